/* What a reader would see go wrong on the page, as JSON in the element `measured`. */
"use strict";
const WIDE = 1; // pixels
const LONGEST = 264 * 96 / 25.4; // of a figure: what A4 leaves for it
const errors = [];
addEventListener("error", (event) => errors.push(event.message));

function name(element) {
  return element.tagName + " " + element.textContent.trim().slice(0, 60);
}

function beyond(inner, outer) {
  return inner.left < outer.left - WIDE || inner.right > outer.right + WIDE
    || inner.top < outer.top - WIDE || inner.bottom > outer.bottom + WIDE;
}

function drawn(svg) {
  const box = svg.getBoundingClientRect(), shape = svg.getBBox();
  return box.width > 300 && box.height > 50 && box.height < LONGEST && shape.width > 100 && shape.height > 50;
}

function cutTexts(svg) {
  const box = svg.getBoundingClientRect();
  return [...svg.querySelectorAll("text")].filter((text) => beyond(text.getBoundingClientRect(), box));
}

function overflowing() {
  const page = document.body.getBoundingClientRect();
  return [...document.querySelectorAll("body *:not(svg *)")].filter((element) => {
    const box = element.getBoundingClientRect();
    const spills = element.clientWidth > 0 && element.scrollWidth > element.clientWidth + WIDE;
    return spills || box.right > page.right + WIDE;
  });
}

function words(element) { // each text beside the box that it stands in
  const range = document.createRange();
  range.selectNodeContents(element);
  return range.getBoundingClientRect();
}

function dangling() {
  const html = document.body.innerHTML;
  const wanted = [...html.matchAll(/(?:href="#|url\(&quot;#|url\(#)([^"&)]+)/g)].map((match) => match[1]);
  return wanted.filter((id) => !document.getElementById(id));
}

addEventListener("load", () => {
  const figures = [...document.querySelectorAll("figure svg")];
  const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
  const cells = [...document.querySelectorAll("td, th, dd, dt, p, h1, h2, h3, h4")];
  const measured = {
    errors,
    figures: figures.length,
    undrawn: figures.filter((svg) => !drawn(svg)).map(name),
    cut: figures.flatMap(cutTexts).map(name),
    overflowing: overflowing().map(name),
    spilling: cells.filter((cell) => cell.textContent.trim() && beyond(words(cell), cell.getBoundingClientRect())).map(name),
    dangling: dangling(),
    repeated: ids.filter((id, i) => ids.indexOf(id) < i),
    foreign: [...document.querySelectorAll("img, iframe, link, object, script:not(#measure)")].map(name),
  };
  const place = document.createElement("pre");
  place.id = "measured";
  place.textContent = JSON.stringify(measured);
  document.body.append(place);
});
