"""Do runs, measure them, and store the results, so that none is computed twice."""
