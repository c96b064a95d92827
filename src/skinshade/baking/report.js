const label = document.querySelector("label"), input = label.querySelector("input");
const counter = label.querySelector("output");
const items = [...document.querySelectorAll("article, li")];
const texts = items.map(item => {
  const group = item.closest("details");
  return (item.textContent + (group ? " failed " + group.firstChild.textContent : "")).toLowerCase();
});
const filter = () => {
  const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
  let count = 0;
  items.forEach((item, index) => {
    item.hidden = !words.every(word => texts[index].includes(word));
    count += !item.hidden;
  });
  for (const group of document.querySelectorAll("details, section")) {
    group.hidden = ![...group.querySelectorAll("article, li")].some(item => !item.hidden);
  }
  counter.textContent = words.length ? `${count} of ${items.length}` : "";
};
input.addEventListener("input", filter);
label.hidden = false;
filter();
