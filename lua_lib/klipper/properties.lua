-- Klipper. Words of other dialects have no meaning there, so it inherits from core alone.

return {
  base = "core",
  module = "gsim.klipper",
  files = {
    "klipper/arcs", "klipper/limits", "klipper/modes", "klipper/moves", "klipper/retraction", "klipper/state",
    "klipper/stored_data",
  },
  always_mm = true,
}
