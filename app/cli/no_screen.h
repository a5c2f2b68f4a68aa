#pragma once

namespace carom {

// Before an application that only draws pictures is made: it needs no display, and says nothing of having none.
void use_no_screen();

}  // namespace carom
