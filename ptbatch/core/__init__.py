"""Compiled mechanics: plain free functions on floats and arrays that know no names, no units and no
workbook."""
