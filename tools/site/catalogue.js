// Search and categories of the catalogue; the address after # keeps what is shown.
"use strict";

const words = document.getElementById("words");
const buttons = [...document.querySelectorAll(".looks button")];
const items = [...document.querySelectorAll(".shelf li")];
let category = "";

function plain(text) {
  return text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
}

function show() {
  const asked = plain(words.value).split(/\s+/).filter(Boolean);
  let count = 0;
  for (const item of items) {
    const fits = (!category || item.dataset.category === category)
      && asked.every((word) => item.dataset.words.includes(word));
    item.hidden = !fits;
    count += fits;
  }
  document.getElementById("found").textContent = count === 1 ? "1 material" : count + " materials";
  document.getElementById("nothing").hidden = count > 0;
  for (const button of buttons) {
    button.setAttribute("aria-pressed", String(button.dataset.category === category));
  }
}

function choose(name) {
  category = buttons.some((button) => button.dataset.category === name) ? name : "";
  show();
}

for (const button of buttons) {
  button.addEventListener("click", () => {
    history.replaceState(null, "", button.dataset.category ? "#" + button.dataset.category : location.pathname);
    choose(button.dataset.category);
  });
}
words.addEventListener("input", show);
window.addEventListener("hashchange", () => choose(location.hash.slice(1)));
choose(location.hash.slice(1));
