#pragma once

/// The dimensions of space and of velocity that a scene can have, in one place.
#define SCREE_FOR_EACH_DIMENSION(INSTANCE) \
  INSTANCE(1, 1) INSTANCE(1, 2) INSTANCE(1, 3) INSTANCE(2, 2) INSTANCE(2, 3) INSTANCE(3, 3)
