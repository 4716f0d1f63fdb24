#include "common/method/capabilities.h"

namespace gibench {

EffectSet effects_of(const Capabilities& can) {
  EffectSet effects = can.effects;
  if (!can.direct) effects.insert(Effect::direct);
  return effects;
}

}  // namespace gibench
