const view = document.querySelector("dialog");
const figures = [...document.querySelectorAll("main figure")];
let shown = 0;

function follow(figure) {
  const range = figure.querySelector("input");
  const pair = figure.querySelector(".pair");
  const move = () => pair.style.setProperty("--at", `${range.value}%`);
  const drag = event => {
    const { left, width } = pair.getBoundingClientRect();
    range.value = (100 * (event.clientX - left)) / width;
    move();
  };
  range.addEventListener("input", move);
  pair.addEventListener("pointerdown", event => {
    pair.setPointerCapture(event.pointerId);
    drag(event);
  });
  pair.addEventListener("pointermove", event => event.buttons && drag(event));
}

function show(number) {
  shown = (number + figures.length) % figures.length;
  const figure = figures[shown];
  const place = view.querySelector("div");
  if (figure.matches(".compare")) {
    const copy = figure.cloneNode(true);
    copy.querySelector(".enlarge").remove();
    const { naturalWidth, naturalHeight } = figure.querySelector("img");
    copy.style.setProperty("--ratio", naturalWidth / naturalHeight);
    copy.querySelector("input").value = figure.querySelector("input").value;
    place.replaceChildren(copy);
    follow(copy);
  } else {
    place.replaceChildren(figure.querySelector("img").cloneNode());
  }
  if (!view.open) view.showModal();
  place.scrollTo(0, 0);
}

for (const figure of figures.filter(each => each.matches(".compare"))) follow(figure);
document.addEventListener("click", event => {
  const enlarge = event.target.closest("main .enlarge");
  if (enlarge) show(figures.indexOf(enlarge.closest("figure")));
  const step = event.target.closest("dialog [data-step]");
  if (step) show(shown + Number(step.dataset.step));
});
view?.addEventListener("keydown", event => {
  if (event.target.matches("input")) return;
  if (event.key === "ArrowRight") show(shown + 1);
  if (event.key === "ArrowLeft") show(shown - 1);
});
view?.addEventListener("close", () => figures[shown].querySelector(".enlarge").focus());

if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
  for (const image of document.querySelectorAll("img[data-moves]")) {
    image.decode().then(() => {
      const still = document.createElement("canvas");
      still.width = image.naturalWidth;
      still.height = image.naturalHeight;
      still.getContext("2d").drawImage(image, 0, 0);
      image.src = still.toDataURL();
    });
  }
}
const contents = document.querySelector("nav details");
if (contents && matchMedia("(min-width: 64rem)").matches) contents.open = true;
