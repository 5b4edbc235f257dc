#pragma once

#include <memory>
#include <utility>

#include "view/picture/look_changes.h"
#include "view/picture/picture_thread.h"
#include "view/server/pages.h"
#include "view/subject/subject.h"
#include "view/view_options.h"

namespace fumon {

/// What the server of a viewer answers. Any thread may ask.
///
///     GET                   the page, its styles and modules: assets/view
///     GET subject           what is shown, and the keys that may change, as JSON
///     GET, POST progress    its moments, and what is being computed
///     GET, POST measurements   columns of numbers
///     GET presets           the looks that fumon ships, as settings
///     POST picture          a picture request as JSON → a draft or picture
///     POST camera           a picture request → where its camera stands
///     POST check            {settings} → nothing, or the fault that `fumon check` would tell
///     POST scene            {settings, name} → the scene's file
///     POST still            a picture request with a name → its file
///     POST film             {shots, settings, name} → the film's file
///
/// A file goes into the folder of --save where there is one, else to the browser.
class ViewPage : public Pages {
  public:
    /// The subject outlives it.
    ViewPage(ViewSubject& subject, ViewOptions options);

    HttpAnswer answer(const HttpRequest& request) override;

    void cancel_all() override { pictures_.cancel_all(); }

  private:
    [[nodiscard]] HttpAnswer subject_answer() const;
    [[nodiscard]] HttpAnswer progress_answer() const;
    [[nodiscard]] HttpAnswer measurements_answer() const;
    HttpAnswer picture_answer(const HttpRequest& request);
    [[nodiscard]] HttpAnswer camera_answer(const HttpRequest& request) const;
    [[nodiscard]] HttpAnswer check_answer(const HttpRequest& request) const;
    HttpAnswer still_answer(const HttpRequest& request);
    [[nodiscard]] HttpAnswer scene_answer(const HttpRequest& request) const;
    [[nodiscard]] HttpAnswer film_answer(const HttpRequest& request) const;

    ViewSubject& subject_;
    ViewOptions options_;
    LookChanges changes_;
    PictureThread pictures_;
};

/// A page with its subject.
class SubjectPages : public Pages {
  public:
    SubjectPages(std::unique_ptr<ViewSubject> subject, ViewOptions options)
        : subject_(std::move(subject)), page_(*subject_, std::move(options)) {}

    HttpAnswer answer(const HttpRequest& request) override { return page_.answer(request); }
    void cancel_all() override { page_.cancel_all(); }

  private:
    std::unique_ptr<ViewSubject> subject_;
    ViewPage page_;
};

}  // namespace fumon
