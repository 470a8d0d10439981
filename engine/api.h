#pragma once

/// What a shared library shows of this interface.
#define GSIM_API __attribute__((visibility("default")))
