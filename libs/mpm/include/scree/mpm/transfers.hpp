#pragma once

#include <scree/mpm/transfers/apic.hpp>
#include <scree/mpm/transfers/pic_flip.hpp>

#include <variant>

namespace scree::mpm {

/// Every transfer. A new one is a line here, its header and its test.
using AnyTransfer = std::variant<Apic, PicFlip>;

}  // namespace scree::mpm
