"""What reports are made with: pages, tables, figures, options."""
