"""Figures of members, from a results workbook or, before any analysis, from an input one."""

from ptbatch.plots.drawing import Drawn as Drawn
from ptbatch.plots.drawing import draw as draw
from ptbatch.plots.drawing import draw_geometry as draw_geometry
from ptbatch.plots.drawing import draw_stored as draw_stored
