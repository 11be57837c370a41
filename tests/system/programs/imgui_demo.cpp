// Dear ImGui's demo window with its OpenGL 2 back end, over GLFW or SDL2: imgui_demo glfw|sdl2. It ends after
// 300 frames.
#include <cstdio>
#include <cstring>

#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <SDL2/SDL.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl2.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

namespace {

constexpr int width = 320, height = 240, frames = 300;

void draw() {
    ImGui::NewFrame();
    ImGui::ShowDemoWindow();
    // The demo window chooses a place for a large screen when it appears, so it is moved here.
    ImGui::SetWindowPos("Dear ImGui Demo", ImVec2(4, 4));
    ImGui::SetWindowSize("Dear ImGui Demo", ImVec2(width - 8, height - 8));
    ImGui::Render();
    glClearColor(0.2f, 0.3f, 0.4f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

bool with_glfw() {
    if (glfwInit() == 0)
        return false;
    GLFWwindow* const window = glfwCreateWindow(width, height, "Dear ImGui", nullptr, nullptr);
    if (window == nullptr)
        return false;
    glfwMakeContextCurrent(window);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL2_Init();
    for (int i = 0; i < frames && glfwWindowShouldClose(window) == 0; ++i) {
        glfwPollEvents();
        ImGui_ImplOpenGL2_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        draw();
        glfwSwapBuffers(window);
    }
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    glfwTerminate();
    return true;
}

bool with_sdl2() {
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
        return false;
    SDL_Window* const window = SDL_CreateWindow("Dear ImGui", 0, 0, width, height, SDL_WINDOW_OPENGL);
    const SDL_GLContext context = window == nullptr ? nullptr : SDL_GL_CreateContext(window);
    if (context == nullptr)
        return false;
    ImGui_ImplSDL2_InitForOpenGL(window, context);
    ImGui_ImplOpenGL2_Init();
    for (int i = 0; i < frames; ++i) {
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0) {
            ImGui_ImplSDL2_ProcessEvent(&event);
            if (event.type == SDL_QUIT)
                i = frames;
        }
        ImGui_ImplOpenGL2_NewFrame();
        ImGui_ImplSDL2_NewFrame();
        draw();
        SDL_GL_SwapWindow(window);
    }
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    SDL_GL_DeleteContext(context);
    SDL_Quit();
    return true;
}

} // namespace

int main(int count, char** words) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    const bool sdl2 = count > 1 && std::strcmp(words[1], "sdl2") == 0;
    if (!(sdl2 ? with_sdl2() : with_glfw())) {
        std::fprintf(stderr, "there is no window with OpenGL\n");
        return 1;
    }
    ImGui::DestroyContext();
    return 0;
}
