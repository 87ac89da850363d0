"""Style exemplars, painted over the render of the sphere."""

from data_gen.styles.crayon import crayon
from data_gen.styles.oil import oil
from data_gen.styles.pen import pen
from data_gen.styles.subject import subject
from data_gen.styles.watercolour import watercolour

STYLES = {"crayon": crayon, "oil": oil, "watercolour": watercolour, "pen": pen}

__all__ = ["STYLES", "subject"]
