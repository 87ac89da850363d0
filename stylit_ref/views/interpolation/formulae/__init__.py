"""One number or one pixel at a time: weights of views, edges of triangles, where points appear."""
