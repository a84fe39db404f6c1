// Elements of the page, and numbers as text.

function byId(id) { return document.getElementById(id); }

function element(tag, className, text) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

// Says in the place of the picture why there is none.
function showFailure(text, error) {
  byId("message").textContent = `${text}: ${error.message}`;
  byId("message").className = "bad";
  throw error;
}

// Three digits after the point, without "-0.000".
function fixed(value, digits = 3) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}
