"""Measure the studio: a real browser, a real server, and a hand that is led by a seed."""
