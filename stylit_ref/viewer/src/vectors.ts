// Three numbers.

export type Vector = [number, number, number];

export const dot = (a: readonly number[], b: readonly number[]): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const minus = (a: readonly number[], b: readonly number[]): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** The sum of vectors, each with its factor. */
export function combine(...terms: readonly (readonly [number, readonly number[]])[]): Vector {
  const sum = (i: number) => terms.reduce((total, [factor, vector]) => total + factor * vector[i], 0);
  return [sum(0), sum(1), sum(2)];
}

export const cross = (a: readonly number[], b: readonly number[]): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export function unit(a: readonly number[]): Vector {
  const length = Math.hypot(a[0], a[1], a[2]);
  return [a[0] / length, a[1] / length, a[2] / length];
}
