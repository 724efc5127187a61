"""`python -m ptbatch`."""

from ptbatch.cli import main

main()
