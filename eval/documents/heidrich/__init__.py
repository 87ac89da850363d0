"""The thesis of Heidrich (2017), chapters 4 to 7, on our stage."""
