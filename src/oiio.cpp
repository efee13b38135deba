#include "oiio.h"

extern "C" const gnomon::ImageFormats gnomon_image_formats;
const gnomon::ImageFormats gnomon_image_formats = {gnomon::write_through_oiio, gnomon::read_exr_through_oiio};
