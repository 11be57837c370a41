#include "gl/api/components.hpp"
#include "gl/api/params.hpp"

namespace spangle::gl {

namespace {

/// Raises an error of an entry point. `text` is a whole sentence, because the caller knows the entry point
/// and not only its family.
void refuse(GLenum code, [[maybe_unused]] const char* text) {
    Context* const context = current_context();
    if (context == nullptr)
        return;
    set_error(*context, code - GL_INVALID_ENUM);
#if SPANGLE_MESSAGES
    message(code, text);
#endif
}

} // namespace

void refuse_null(const char* text) {
    refuse(GL_INVALID_VALUE, text);
}

void refuse_feature(const char* text) {
    refuse(GL_INVALID_OPERATION, text);
}

bool may_run_here(Context& context, const list::Player& command) {
#if SPANGLE_FEATURE_BANDS
    if ((context.gate & command.stops & gate_left_out) != 0)
        return false;
#endif
    return (command.stops & gate_inside) == 0 || allowed_outside(context, command.text);
}

void call(Context& context, const Run& run, std::size_t count, const Arg (&args)[most_args]) {
    if (count <= few_args)
        Few::call(run.few, context, args);
    else if (count <= some_args)
        Some::call(run.some, context, args);
    else
        Many::call(run.many, context, args);
}

#if SPANGLE_WATCHED
void watch(Context& context, Watcher* watcher) {
    context.watcher = watcher;
    const int others = context.gate & ~gate_watched;
    context.gate = static_cast<std::uint8_t>(watcher != nullptr ? others | gate_watched : others);
    context.changed(dirty_fragment);
}
#endif

bool must_run_now(Context& context, const Command& command, [[maybe_unused]] const Arg (&args)[most_args]) {
    tell_watcher(context, command.text, args, command.args);
#if SPANGLE_FEATURE_LISTS
    if ((context.gate & gate_compiling) != 0) { // display lists record all commands that come here
#if SPANGLE_MESSAGES
        context.compiled = {command.text, args};
#endif
        if (command.form == list::Form::encoded)
            call(context, static_cast<const EncodedCommand&>(command).encode, command.args, args);
        else
            list::write(context, command, args);
        explain_error(context, command.text, args, command.args);
        if (!context.list.execute)
            return false;
    }
#endif
    return may_run_here(context, command);
}

#if SPANGLE_ARGUMENTS_INLINE && !SPANGLE_FEATURE_LISTS
Context* admitted(const Command& command) {
    Context* const context = current_context();
    return context != nullptr && may_run_here(*context, command) ? context : nullptr;
}
#endif

#if !SPANGLE_ARGUMENTS_INLINE
void issue_args(const Command& command, const Arg* args) {
    Context* const context = current_context();
    if (context == nullptr)
        return;
    Arg given[most_args] = {};
    for (unsigned i = 0; i < command.args; ++i)
        given[i] = args[i];
    if (must_run_now(*context, command, given))
        call(*context, command.run, command.args, given);
    explain_error(*context, command.text, given, command.args);
}

[[gnu::noinline]] void issue_few(const Command& command) {
    issue_args(command, nullptr);
}
[[gnu::noinline]] void issue_few(Arg a, const Command& command) {
    issue_args(command, &a);
}
[[gnu::noinline]] void issue_few(Arg a, Arg b, const Command& command) {
    const Arg args[] = {a, b};
    issue_args(command, args);
}
[[gnu::noinline]] void issue_few(Arg a, Arg b, Arg c, const Command& command) {
    const Arg args[] = {a, b, c};
    issue_args(command, args);
}
#endif

namespace {

/// Issues a command with as many values as its pname has. If the entry point takes a single value but the
/// pname has several, the count is 0, and the command raises INVALID_ENUM.
[[gnu::noinline]] void issue_shaped(GLenum target, GLenum pname, const void* values, convert::Number type,
                                    const ParamFamily& family, bool single) {
    Shape shape = find_shape(family.rows, pname);
    if (single && shape.count != 1)
        shape.count = 0;
    const Params params = convert::vector(shape, values, type);
    const Arg last = Passed<const Params&>::arg(params);
    // Commands without a target do not use the last argument.
    const bool targets = family.command->args == few_args;
    issue_command(*family.command, Arg{targets ? target : pname}, targets ? Arg{pname} : last, last);
}

} // namespace

[[gnu::noinline]] void issue_value(GLenum target, GLenum pname, std::uint32_t word, convert::Number type,
                                   const ParamFamily& family) {
    issue_shaped(target, pname, &word, type, family, true);
}

[[gnu::noinline]] void issue_values(GLenum target, GLenum pname, const void* values, convert::Number type,
                                    const ParamFamily& family, const char* null_text) {
    if (values == nullptr)
        return refuse_null(null_text);
    issue_shaped(target, pname, values, type, family, false);
}

#if !SPANGLE_ARGUMENTS_INLINE
void issue_loaded(const void* v, convert::Components kind, const Command& command, const char* null_text) {
    if (is_left_out(command.stops) && v != nullptr)
        return;
    const convert::Loaded loaded = convert::load(v, kind, null_text);
    if (loaded.null)
        return;
    Arg args[convert::most_components];
    for (std::size_t i = 0; i < convert::most_components; ++i)
        args[i] = loaded.at[i].bits;
    issue_args(command, args);
}

void issue_loaded_at(GLenum target, const void* v, convert::Components kind, const Command& command,
                     const char* null_text) {
    const convert::Loaded loaded = convert::load(v, kind, null_text);
    if (loaded.null)
        return;
    Arg args[1 + convert::most_components] = {target};
    for (std::size_t i = 0; i < convert::most_components; ++i)
        args[1 + i] = loaded.at[i].bits;
    issue_args(command, args);
}

void issue_loaded_matrix(const void* m, convert::Element kind, const Command& command,
                         const char* null_text) {
    if (m == nullptr)
        return refuse_null(null_text);
    const Matrix16 matrix = convert::matrix(m, kind);
    issue_command(command, Passed<const Matrix16&>::arg(matrix));
}
#endif

Context* outside_begin_end(const CommandText* text) {
    Context* const context = current_context();
    return context != nullptr && allowed_outside(*context, text) ? context : nullptr;
}

} // namespace spangle::gl
