#!/usr/bin/env bash
# Everything that has to hold before a change is good: all checks, then all tests.
cd "$(dirname "$0")/.." && . scripts/common.sh
scripts/setup.sh --lint --tests
scripts/lint.sh

# The tests draw with lavapipe, which gives (nearly) the same picture everywhere, and there no picture
# may go uncompared. Whoever names a driver tests that driver instead; macOS has no lavapipe.
if [ -z "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] && driver=$(lavapipe); then
    # The second name is that of loaders before Vulkan 1.3.207.
    export VK_DRIVER_FILES="$driver" VK_ICD_FILENAMES="$driver"
    export FUMETTO_GOLDEN_REQUIRED=1
fi
# Nor may the tests in a browser be passed over where setup.sh has seen to one.
if [ "$(uname -s)" = Linux ]; then
    export FUMETTO_BROWSER_REQUIRED=1
fi
# Random tests try the same everywhere, so that what passes here passes there. Other seeds find more.
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-1}"
check "tests" cargo test --locked --workspace
