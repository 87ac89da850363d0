"""The paper's equations: seam costs (4), the polar map (4, Appendix A), deformation (5)."""
