"""Paint, and the target follows: a page in the browser (Heidrich 2017, 4 and 5.1)."""
