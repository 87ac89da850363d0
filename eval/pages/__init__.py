"""Parts of reports: pages, tables, figures, options."""
