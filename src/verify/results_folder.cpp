#include "verify/results_folder.h"

#include <filesystem>

#include "base/error.h"
#include "outputs/output_claims.h"

namespace fumon {

ResultsFolder results_folder(const VerificationOptions& options) {
    const std::string folder = last_results(options);
    std::error_code fault;
    // What records makes no results, and clears those that are there.
    if (options.update && !std::filesystem::exists(folder, fault)) return {folder, ""};
    try {
        check_output_folder(folder, "the pictures");
    } catch (const InputError&) {
        throw;
    } catch (const Error& refused) {
        if (!options.folder.empty()) throw;
        return {"", refused.what()};
    }
    return {folder, ""};
}

std::string last_results(const VerificationOptions& options) {
    return options.folder.empty() ? usual_results : options.folder;
}

}  // namespace fumon
