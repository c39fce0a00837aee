// What the engine calls of the page.
mergeInto(LibraryManager.library, {
  stillpoint_progress:
    "(words) => { if (Module['progress']) Module['progress'](UTF8ToString(words)); }",
});

// Functions that NLopt calls for algorithms that no design can request (nlopt_algorithms() lists those that it
// can): half of its code, and a table of 130 kB.
mergeInto(
  LibraryManager.library,
  Object.fromEntries(
    [
      "direct_optimize",
      "praxis_",
      "luksan_plis",
      "luksan_plip",
      "luksan_pnet",
      "mlsl_minimize",
      "newuoa",
      "bobyqa",
      "auglag_minimize",
      "isres_minimize",
      "chevolutionarystrategy",
      "nlopt_sobol_create",
      "nlopt_sobol_destroy",
      "nlopt_sobol_next",
      "nlopt_sobol_next01",
      "nlopt_sobol_skip",
    ].map((name) => [name, `() => abort("${name}")`]),
  ),
);
