-- What golden programs of Klipper find on the machine: nothing but its words.
local _ENV = require "gsim.klipper"
