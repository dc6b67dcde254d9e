"""Screws in four quadrants: the plant's form beside measured curves of the Wageningen B-series."""
