"""The mesh must be one that a machine can bear."""

from collections.abc import Iterator

from ptbatch.rules.fault import Fault, Rule, Values, counted, rule

# Far beyond what a result depends on. A member of so many elements takes seconds and 0.2 GB.
MOST_ELEMENTS, MOST_LAYERS = 2_000, 1_000


@rule("span", "elements")
def elements_bearable(v: Values) -> Iterator[Fault]:
    """Elements of all spans together."""
    spans = len(v["span"])
    if spans * v["elements"] > MOST_ELEMENTS:
        wrong = f"over {counted(spans, 'span')} these are {spans * v['elements']}, more than {MOST_ELEMENTS}"
        yield Fault("elements", v["elements"], wrong, "give fewer; 20 a span is usual")


@rule("layers")
def layers_bearable(v: Values) -> Iterator[Fault]:
    """Layers of the section."""
    if v["layers"] > MOST_LAYERS:
        wrong = f"these are more than {MOST_LAYERS}"
        yield Fault("layers", v["layers"], wrong, "give fewer; 40 is usual")


RULES: tuple[Rule, ...] = (elements_bearable, layers_bearable)
