local part = path{name="part", tool=3, work_offset="G55", probe_offset={{axis="Z", from_mm={0, 0, 9}, to_mm=-1, surface_mm=0, feed_mm_min=60, tool=9}},
  point{reference=1}, point{fixed="CLAMP1", dwell_s=1}, point{motion="rapid", position_mm={1, 2, 30}, tool_axis={0, 0, 1}}}
return path{name="job", tool=3, repeated(1, part, {work_offset="G56", probe_offset={{axis="X", from_mm={0, 0, 9}, to_mm=5, surface_mm=4, feed_mm_min=60, probe_radius_mm=1}}})}
