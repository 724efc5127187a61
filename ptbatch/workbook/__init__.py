"""Spreadsheets: what a column means, reading members from a workbook, writing results to another."""
