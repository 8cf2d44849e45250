/* Run only by browsers that know no modules: says that they are too old. Written so that these understand it. */
document.addEventListener("DOMContentLoaded", function () {
  var strip = document.getElementById("strip");
  strip.firstChild.textContent =
    "这个浏览器太旧，请使用较新的 Chrome、Edge、Firefox 或 Safari。 / This browser is too old: please use a recent Chrome, Edge, Firefox or Safari.";
  strip.removeAttribute("hidden");
  document.getElementById("starting").setAttribute("hidden", "");
});
