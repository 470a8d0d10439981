local part = path{name = "part", tool = 3, length_offset = 4, diameter_offset = 5, point{motion = "rapid", position_mm = {10, 20, 10}}}
return path{name = "job", work_offset = "G54", repeated(2, part, {work_offset = "G55", set_offset_mm = {100, 50, -20}})}
