// The interactive views of a report: one canvas for each run, with a shared
// camera, a shared time and shared colours, so that valves can be compared.
// The page holds a JSON element "view-data" with what views.py has written.

import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, CylinderGeometry,
  DirectionalLight, DoubleSide, InstancedMesh, Matrix4, Mesh,
  MeshPhongMaterial, OrthographicCamera, Plane, Quaternion, Scene, Vector3,
  WebGLRenderer,
} from 'three';

const views = [];
const shared = {
  field: null, chordae: true, cut: 0, time: 1,
  orientation: new Quaternion(), // of the camera
  centre: new Vector3(),         // what it looks at, mm
  zoom: 1,
};

// Camera orientations, in millimetres with z towards the atrium and y towards
// the anterior side: direction towards the camera, its upper side, height of
// the centre.
const looks = {
  atrium: [[0, 0, 1], [0, 1, 0], 0],
  ventricle: [[0, 0, -1], [0, 1, 0], 0],
  side: [[0.45, -0.9, 0.25], [0, 0, 1], -12],
  front: [[0, -1, 0], [0, 0, 1], -12],
};

function lookFrom(name) {
  const [direction, up, height] = looks[name];
  const matrix = new Matrix4().lookAt(
    new Vector3(...direction), new Vector3(), new Vector3(...up));
  shared.orientation.setFromRotationMatrix(matrix);
  shared.centre.set(0, 0, height);
  shared.zoom = 1;
}

// Turns the valve by a drag of (x, y) pixels, as if held in the hand.
function turn(x, y) {
  const angle = Math.hypot(x, y) / 150;
  if (angle === 0) return;
  const axis = new Vector3(-y, -x, 0).normalize();
  shared.orientation.multiply(new Quaternion().setFromAxisAngle(axis, angle));
}

function drawAll() {
  for (const view of views) view.draw();
}

function bytes(text) {
  const binary = atob(text);
  const result = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) result[i] = binary.charCodeAt(i);
  return result.buffer;
}

// Colours of a table of RGB bytes, linear between its entries.
function colourOf(table, value, out, offset) {
  const n = table.length / 3 - 1;
  const s = Math.min(Math.max(value, 0), 1) * n;
  const i = Math.min(Math.floor(s), n - 1);
  const f = s - i;
  for (let c = 0; c < 3; ++c)
    out[offset + c] = (table[3 * i + c] * (1 - f) + table[3 * i + 3 + c] * f) / 255;
}

class View {
  constructor(canvas, data, tables) {
    this.canvas = canvas;
    this.data = data;
    this.tables = tables;
    this.n = data.nodes;
    this.positions = new Uint16Array(bytes(data.positions));
    this.fields = {};
    for (const [name, field] of Object.entries(data.fields))
      this.fields[name] = new Uint8Array(bytes(field));
    this.chordae = new Float32Array(bytes(data.chordae));

    this.renderer = new WebGLRenderer(
      { canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setClearColor(0xffffff);
    this.renderer.localClippingEnabled = true;
    this.plane = new Plane(new Vector3(-1, 0, 0), 0);
    this.buildScene();
    this.buildCamera();
  }

  buildScene() {
    this.scene = new Scene();
    this.scene.add(new AmbientLight(0xffffff, 1.3));
    this.lamp = new DirectionalLight(0xffffff, 2.2);
    this.scene.add(this.lamp);

    this.geometry = new BufferGeometry();
    this.geometry.setIndex(
      new BufferAttribute(new Uint32Array(bytes(this.data.triangles)), 1));
    this.geometry.setAttribute(
      'position', new BufferAttribute(new Float32Array(3 * this.n), 3));
    this.geometry.setAttribute(
      'color', new BufferAttribute(new Float32Array(3 * this.n), 3));
    this.tissue = new MeshPhongMaterial({
      vertexColors: true, side: DoubleSide, shininess: 12, specular: 0x222222 });
    this.scene.add(new Mesh(this.geometry, this.tissue));

    this.strings = new InstancedMesh(
      new CylinderGeometry(1, 1, 1, 8),
      new MeshPhongMaterial({ color: 0x8a6d4b, shininess: 8 }),
      Math.max(1, this.data.n_chordae));
    this.strings.frustumCulled = false;
    this.scene.add(this.strings);
  }

  buildCamera() {
    this.camera = new OrthographicCamera(-1, 1, 1, -1, -500, 500);
    const pointers = new Map();
    const spread = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    for (const name of ['pointerup', 'pointercancel'])
      this.canvas.addEventListener(name, (event) => pointers.delete(event.pointerId));
    this.canvas.addEventListener('pointermove', (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const before = pointers.size === 2 ? spread() : 0;
      const [x, y] = [event.clientX - last.x, event.clientY - last.y];
      last.x = event.clientX;
      last.y = event.clientY;
      if (pointers.size === 1) turn(x, y);
      else if (pointers.size === 2) shared.zoom *= spread() / Math.max(before, 1);
      drawAll();
    });
    this.canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      shared.zoom *= Math.exp(-1e-3 * event.deltaY);
      drawAll();
    }, { passive: false });
  }

  frame() {
    return Math.round(shared.time * (this.data.times.length - 1));
  }

  update() {
    const frame = this.frame();
    const position = this.geometry.attributes.position.array;
    const { lower, upper } = this.data;
    for (let i = 0; i < 3 * this.n; ++i)
      position[i] = lower[i % 3] + (upper[i % 3] - lower[i % 3]) / 65535 *
        this.positions[3 * this.n * frame + i];
    const color = this.geometry.attributes.color.array;
    const values = this.fields[shared.field];
    const table = this.tables[shared.field];
    for (let i = 0; i < this.n; ++i)
      if (values) colourOf(table, values[this.n * frame + i] / 255, color, 3 * i);
      else color.set([0.9, 0.75, 0.68], 3 * i);
    // Colours of the tables are those of the screen.
    const c = new Color();
    for (let i = 0; i < this.n; ++i) {
      c.setRGB(color[3 * i], color[3 * i + 1], color[3 * i + 2], 'srgb');
      color[3 * i] = c.r; color[3 * i + 1] = c.g; color[3 * i + 2] = c.b;
    }
    this.geometry.attributes.position.needsUpdate = true;
    this.geometry.attributes.color.needsUpdate = true;
    this.geometry.computeVertexNormals();
    this.placeChordae(frame);
    this.draw();
  }

  placeChordae(frame) {
    const n = this.data.n_chordae;
    const matrix = new Matrix4();
    const turn = new Quaternion();
    const axis = new Vector3(0, 1, 0);
    for (let i = 0; i < n; ++i) {
      const [ax, ay, az, bx, by, bz] = this.chordae.slice(
        6 * (n * frame + i), 6 * (n * frame + i + 1));
      const a = new Vector3(ax, ay, az);
      const b = new Vector3(bx, by, bz);
      const length = a.distanceTo(b);
      turn.setFromUnitVectors(axis, b.clone().sub(a).normalize());
      matrix.compose(a.add(b).multiplyScalar(0.5), turn,
        new Vector3(0.28, length, 0.28));
      this.strings.setMatrixAt(i, matrix);
    }
    this.strings.count = n;
    this.strings.instanceMatrix.needsUpdate = true;
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    const half = 19; // mm, the half width that shows the whole valve
    const scale = half / Math.min(1, width / height);
    this.camera.left = -scale * width / height;
    this.camera.right = -this.camera.left;
    this.camera.top = scale;
    this.camera.bottom = -scale;
    this.camera.zoom = shared.zoom;
    this.camera.updateProjectionMatrix();
    this.camera.quaternion.copy(shared.orientation);
    this.camera.position.copy(shared.centre);
    // The lamp stands behind the left shoulder of whoever looks.
    this.lamp.position.set(-0.4, 0.6, 1).applyQuaternion(shared.orientation);
    this.strings.visible = shared.chordae;
    this.plane.constant = 19 * (1 - shared.cut);
    this.tissue.clippingPlanes = shared.cut > 0 ? [this.plane] : [];
    this.renderer.render(this.scene, this.camera);
  }
}

function updateAll() {
  for (const view of views) {
    view.update();
    const time = view.data.times[view.frame()];
    const label = document.getElementById(`${view.canvas.id}-time`);
    label.textContent = `${(1e3 * time).toFixed(1)} ms`;
  }
  for (const legend of document.querySelectorAll('.legend-3d'))
    legend.hidden = legend.dataset.field !== shared.field;
}

function connectControls() {
  const field = document.getElementById('view-field');
  shared.field = field.value;
  field.addEventListener('input', () => { shared.field = field.value; updateAll(); });
  const chordae = document.getElementById('view-chordae');
  chordae.addEventListener('input', () => { shared.chordae = chordae.checked; updateAll(); });
  for (const name of ['time', 'cut']) {
    const slider = document.getElementById(`view-${name}`);
    shared[name] = Number(slider.value);
    slider.addEventListener('input', () => { shared[name] = Number(slider.value); updateAll(); });
  }
  for (const button of document.querySelectorAll('[data-look]'))
    button.addEventListener('click', () => {
      lookFrom(button.dataset.look);
      drawAll();
    });
}

function start() {
  const element = document.getElementById('view-data');
  if (!element) return;
  const data = JSON.parse(element.textContent);
  const tables = {};
  for (const [name, table] of Object.entries(data.tables))
    tables[name] = new Uint8Array(bytes(table));
  connectControls();
  lookFrom('atrium');
  data.runs.forEach((run, i) => {
    const canvas = document.getElementById(`view-${i}`);
    try {
      views.push(new View(canvas, run, tables));
    } catch (error) {
      canvas.replaceWith(
        'This browser shows no 3D graphics (WebGL); the pictures above do without.');
    }
  });
  updateAll();
  new ResizeObserver(drawAll)
    .observe(document.getElementById('views'));
}

start();
