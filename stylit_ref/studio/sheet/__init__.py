"""The painting on paper: a sheet to print, and what a scan or photograph of it shows."""
