"""A report for the office: results of members as one HTML file that needs nothing else and prints well."""

from ptbatch.report.document import Reported as Reported
from ptbatch.report.document import write_report as write_report
