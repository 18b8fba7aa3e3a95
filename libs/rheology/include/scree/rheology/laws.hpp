#pragma once

#include <scree/rheology/laws/bingham.hpp>
#include <scree/rheology/laws/breakage.hpp>
#include <scree/rheology/laws/compressible_mu_of_i.hpp>
#include <scree/rheology/laws/drucker_prager.hpp>
#include <scree/rheology/laws/elastic_herschel_bulkley.hpp>
#include <scree/rheology/laws/granular_elastoviscoplastic.hpp>
#include <scree/rheology/laws/herschel_bulkley.hpp>
#include <scree/rheology/laws/kinetic_theory.hpp>
#include <scree/rheology/laws/mixture_mu_of_i.hpp>
#include <scree/rheology/laws/modified_cam_clay.hpp>
#include <scree/rheology/laws/mohr_coulomb.hpp>
#include <scree/rheology/laws/mu_of_i.hpp>
#include <scree/rheology/laws/mu_phi_of_i.hpp>
#include <scree/rheology/laws/newtonian.hpp>
#include <scree/rheology/laws/regularised_mu_of_i.hpp>
#include <scree/rheology/laws/size_dependent_newtonian.hpp>
#include <scree/rheology/laws/suspension.hpp>

#include <variant>

namespace scree::rheology {

/// Every constitutive law. A new one is a line here: scenes can then name it, and every property test runs
/// on it.
using AnyLaw = std::variant<Bingham, Breakage, CompressibleMuOfI, DruckerPrager, ElasticHerschelBulkley,
                            GranularElastoviscoplastic, HerschelBulkley, KineticTheory, MixtureMuOfI,
                            ModifiedCamClay, MohrCoulomb, MuOfI, MuPhiOfI, Newtonian, RegularisedMuOfI,
                            SizeDependentNewtonian, Suspension>;

}  // namespace scree::rheology
