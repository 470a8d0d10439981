// Emulated headset: the WebXR interface to a page, for a browser without a device. Pictures are due when the
// test requests them, at times of its own. Those of the window stop meanwhile, as on a headset that is its
// own computer, or continue, as on a desk.

/** Runs in the page before its own code; `window.headset` is the interface for the test. */
export function emulateHeadset({ refuses = "", lacksFloor = false, layers = false, onDesk = false, width_px = 640, height_px = 640 } = {}) {
  const EYES_M = 0.064;
  const head = { x_m: 0, y_m: 1.7, z_m: 0, turn: 0, down: 0 };
  let session = null;

  const windowRequest = window.requestAnimationFrame.bind(window);
  const windowCancel = window.cancelAnimationFrame.bind(window);
  let held = new Map();
  let lastHeld = -1;
  let requests = 0;
  window.requestAnimationFrame = (callback) => {
    ++requests;
    if (!session || onDesk) return windowRequest(callback);
    held.set(--lastHeld, callback);
    return lastHeld;
  };
  window.cancelAnimationFrame = (id) => (id < 0 ? held.delete(id) : windowCancel(id));

  let draws = 0;
  for (const name of ["drawArrays", "drawElements"]) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...given) {
      ++draws;
      return draw.apply(this, given);
    };
  }

  /** Returns the transformation of an eye at a position: tilted, then turned about Y. */
  function transformOf([x, y, z]) {
    const { turn, down } = head;
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const [ct, st] = [Math.cos(-down), Math.sin(-down)];
    const [ch, sh] = [Math.cos(turn / 2), Math.sin(turn / 2)];
    const [cth, sth] = [Math.cos(-down / 2), Math.sin(-down / 2)];
    return {
      position: { x, y, z, w: 1 },
      orientation: { x: ch * sth, y: sh * cth, z: -sh * sth, w: ch * cth },
      matrix: new Float32Array([c, 0, -s, 0, s * st, ct, c * st, 0, s * ct, -st, c * ct, 0, x, y, z, 1]),
    };
  }
  /** 90 degrees wide and high. */
  function projection({ depthNear: near, depthFar: far }) {
    const [c, d] = [(far + near) / (near - far), (2 * far * near) / (near - far)];
    return new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, c, -1, 0, 0, d, 0]);
  }
  function pose(state) {
    const place = (off_m) => [head.x_m + off_m * Math.cos(head.turn), head.y_m, head.z_m - off_m * Math.sin(head.turn)];
    const view = (eye, off_m) => ({ eye, projectionMatrix: projection(state), transform: transformOf(place(off_m)) });
    return { transform: transformOf(place(0)), views: [view("left", -EYES_M / 2), view("right", EYES_M / 2)] };
  }
  const viewportOf = ({ eye }) => ({ x: eye === "left" ? 0 : width_px, y: 0, width: width_px, height: height_px });

  /** A framebuffer of the device, which the page cannot read; here the test can. */
  function makeBuffer(gl) {
    const bound = [gl.getParameter(gl.FRAMEBUFFER_BINDING), gl.getParameter(gl.TEXTURE_BINDING_2D)];
    const texture = (format) => {
      const made = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, made);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, 2 * width_px, height_px);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      return made;
    };
    const [colour, depth] = [texture(gl.RGBA8), texture(gl.DEPTH_COMPONENT24)];
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, colour, 0);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, bound[0]);
    gl.bindTexture(gl.TEXTURE_2D, bound[1]);
    return { gl, framebuffer, colour, depth };
  }
  let buffer = null;

  WebGL2RenderingContext.prototype.makeXRCompatible = async () => undefined;
  window.XRWebGLLayer = class {
    constructor(_session, gl) {
      buffer = makeBuffer(gl);
      Object.assign(this, { framebuffer: buffer.framebuffer, framebufferWidth: 2 * width_px, framebufferHeight: height_px });
    }
    getViewport(view) {
      return viewportOf(view);
    }
  };
  window.XRWebGLBinding = class {
    constructor(_session, gl) {
      this.gl = gl;
    }
    getViewSubImage(_layer, view) {
      return { colorTexture: buffer.colour, depthStencilTexture: buffer.depth, viewport: viewportOf(view) };
    }
  };
  if (layers) {
    // As with a graphics card that smooths edges, and composes the picture after drawing.
    const getExtension = WebGL2RenderingContext.prototype.getExtension;
    WebGL2RenderingContext.prototype.getExtension = function (name) {
      return name === "WEBGL_debug_renderer_info" ? null : getExtension.call(this, name);
    };
    window.XRWebGLBinding.prototype.createProjectionLayer = function () {
      buffer = makeBuffer(this.gl);
      return { textureWidth: 2 * width_px, textureHeight: height_px, ignoreDepthValues: false };
    };
  }

  class Session extends EventTarget {
    renderState = { depthNear: 0.1, depthFar: 1000, baseLayer: null };
    inputSources = [];
    enabledFeatures = ["local-floor"];
    environmentBlendMode = "opaque";
    callbacks = new Map();
    last = 0;
    now_ms = performance.now();
    updateRenderState(state) {
      this.next = { ...this.next, ...state };
    }
    async requestReferenceSpace(type) {
      if (lacksFloor || type !== "local-floor") throw new DOMException(`no ${type}`, "NotSupportedError");
      return { type };
    }
    requestAnimationFrame(callback) {
      this.callbacks.set(++this.last, callback);
      return this.last;
    }
    cancelAnimationFrame(id) {
      this.callbacks.delete(id);
    }
    /** As the page ends it, and the device does. */
    async end() {
      if (session !== this) throw new DOMException("it has ended", "InvalidStateError");
      session = null;
      this.dispatchEvent(new Event("end"));
      const waited = held;
      held = new Map();
      for (const callback of waited.values()) windowRequest(callback);
    }
    show(passed_ms) {
      this.now_ms += passed_ms;
      Object.assign(this.renderState, this.next);
      const { gl, framebuffer } = buffer;
      const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.clearBufferfv(gl.COLOR, 0, [1, 0, 1, 1]);
      gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
      const dueCallbacks = [...this.callbacks.values()];
      this.callbacks.clear();
      const frame = { session: this, getViewerPose: () => pose(this.renderState), getPose: () => null };
      for (const callback of dueCallbacks) callback(this.now_ms, frame);
    }
  }

  Object.defineProperty(navigator, "xr", {
    value: {
      asked: 0,
      async isSessionSupported(mode) {
        ++this.asked;
        return mode === "immersive-vr";
      },
      async requestSession(mode, { requiredFeatures = [] } = {}) {
        if (refuses) throw new DOMException(refuses, "NotAllowedError");
        if (mode !== "immersive-vr" || !requiredFeatures.includes("local-floor")) throw new DOMException("no", "NotSupportedError");
        session = new Session();
        return session;
      },
    },
  });

  window.headset = {
    head,
    isOn: () => session !== null,
    /** Of pictures of the window, since it was opened. */
    requests: () => requests,
    /** What has been drawn, wherever. */
    draws: () => draws,
    /** Pictures are shown, one each so many ms. */
    show(pictures = 1, passed_ms = 10) {
      for (let i = 0; i < pictures; ++i) session.show(passed_ms);
    },
    /** Hands with sticks, from -1 to 1: to the right, and towards the person. */
    hold(sticks) {
      session.inputSources = Object.entries(sticks).map(([handedness, axes]) => ({
        handedness,
        targetRayMode: "tracked-pointer",
        gamepad: { mapping: "xr-standard", axes: [0, 0, ...axes], buttons: [] },
      }));
    },
    press(what) {
      const event = new Event(what);
      event.inputSource = session.inputSources[0] ?? { handedness: "none" };
      session.dispatchEvent(event);
    },
    takeOff: () => session.end(),
    /** What both eyes have been shown, row by row from above. */
    pixels() {
      const { gl, framebuffer } = buffer;
      const [width, height] = [2 * width_px, height_px];
      const [read, pack] = [new Uint8Array(4 * width * height), new Uint8ClampedArray(4 * width * height)];
      const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, read);
      gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
      for (let y = 0; y < height; ++y) pack.set(read.subarray(4 * width * y, 4 * width * (y + 1)), 4 * width * (height - 1 - y));
      return { width, height, data: pack };
    },
    /** As a picture, in base64. */
    picture() {
      const { width, height, data } = this.pixels();
      const canvas = document.createElement("canvas");
      Object.assign(canvas, { width, height });
      canvas.getContext("2d").putImageData(new ImageData(data, width, height), 0, 0);
      return canvas.toDataURL("image/png").split(",")[1];
    },
  };
}
