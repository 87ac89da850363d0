"""Files on the disk: their names, their headers, their bytes, and writing them whole."""
