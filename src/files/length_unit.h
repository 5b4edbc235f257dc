#pragma once

#include "files/unit_conversion.h"
