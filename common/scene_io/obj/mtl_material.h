/// Materials of MTL files as gibench simulates them.
#pragma once

#include "common/scene_io/model_parts/model_pictures.h"
#include "common/scene_io/obj/mtl_text.h"

namespace gibench {

/// Kd is the albedo, Ks with Ns a Phong lobe or a mirror, as `illum` says (2 where it does not stand); a metal (Pm above 0) is
/// GGX, its colour Kd blended as glTF does, as rough as Pr says, or else Ns. A picture without its colour multiplies 1; without
/// both the albedo is default_albedo. `use` are the texture points of its surfaces.
Material material_of(const MtlMaterial& stated, const PictureUse& use, ModelPictures& pictures, MaterialRemarks& remarks);

}  // namespace gibench
