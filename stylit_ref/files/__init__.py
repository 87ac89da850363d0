"""Files in and out, whole or not at all: images of any depth, nearest-neighbour fields."""
