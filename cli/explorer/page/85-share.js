// SPDX-License-Identifier: MIT
// The state to take along: a text to copy or to save.
"use strict";

/** @param {string} title @param {string} text @param {string} file */
function share(title, text, file) {
  const dialog = /** @type {HTMLDialogElement} */ (el("share"));
  const area = /** @type {HTMLTextAreaElement} */ (/** @type {unknown} */ (el("share-text")));
  el("share-title").textContent = title;
  area.value = text;
  el("share-copy").textContent = "Copy";
  el("share-copy").onclick = () => copy(area);
  el("share-save").onclick = () => save(text, file);
  dialog.showModal();
  area.select();
}

/** @param {HTMLTextAreaElement} area */
async function copy(area) {
  area.select();
  try {
    await navigator.clipboard.writeText(area.value);
    el("share-copy").textContent = "Copied";
  } catch {
    // A page from a file may not be allowed to copy; the reader can copy what is selected.
    el("share-copy").textContent = document.execCommand("copy") ? "Copied" : "Press Ctrl+C";
  }
}

/** @param {string} text @param {string} file */
function save(text, file) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  link.download = file;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
