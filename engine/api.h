#pragma once

/// The symbols of this interface that a shared library exports.
#define GSIM_API __attribute__((visibility("default")))
