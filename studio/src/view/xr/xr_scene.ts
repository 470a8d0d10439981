// Cell as seen by a person in it: metres in place of mm, Y up in place of Z, and a floor.

import { Box3, Color, Group, Matrix4, PerspectiveCamera, Scene, Vector3 } from "three";
import { CameraRig } from "../camera";
import type { FrameAppearance } from "../path/path_layer";
import type { View } from "../view";
import { createFloor } from "./floor";
import type { FloorPose, FloorPosition } from "./floor_pose";
import { XrPaths } from "./xr_paths";

const M_PER_MM = 0.001;
/** Distance from the foremost body to the person on entry, m. */
const START_DISTANCE_M = 1.5;
/** Near limit of an eye, and distance beyond the cell that is still visible, m. */
const NEAR_PLANE_M = 0.05;
const FAR_MARGIN_M = 60;

/** Returns the matrix from the cell's frame to the person's. */
function toSceneMatrix(floor_mm: number): Matrix4 {
  const turned = new Matrix4().makeBasis(new Vector3(1, 0, 0), new Vector3(0, 0, -1), new Vector3(0, 1, 0));
  return turned.scale(new Vector3().setScalar(M_PER_MM)).multiply(new Matrix4().makeTranslation(0, 0, -floor_mm));
}

export class XrScene {
  readonly camera = new PerspectiveCamera();
  /** Start in front of the machine, in the direction of the view "front". */
  readonly entry: FloorPosition;
  private readonly scene = new Scene();
  private readonly cell = new Group();
  private readonly xrPaths = new XrPaths();
  private readonly viewer = new Group();
  private readonly floor: ReturnType<typeof createFloor>;
  /** Lamp at the position of the view "corner". */
  private readonly lamp = new CameraRig();

  private readonly background = new Color();

  constructor(private readonly view: View) {
    const bodies = view.runScene.fullBox();
    this.cell.matrixAutoUpdate = false;
    this.cell.matrix.copy(toSceneMatrix(bodies.min.z));
    const box = new Box3().copy(bodies).applyMatrix4(this.cell.matrix);
    this.entry = { x_m: (box.min.x + box.max.x) / 2, z_m: box.max.z + START_DISTANCE_M };
    this.camera.near = NEAR_PLANE_M;
    this.camera.far = box.getSize(new Vector3()).length() + FAR_MARGIN_M;
    this.floor = createFloor(view.runScene.grid.boldLines.material);
    this.floor.position.set(Math.round(this.entry.x_m), 0, Math.round(box.getCenter(new Vector3()).z));
    this.cell.add(this.xrPaths.group);
    this.viewer.add(this.camera);
    this.scene.add(this.cell, this.floor, this.viewer);
    this.scene.background = this.background;
  }

  /** Draws both eyes; the page's scene is lent for it, and is unchanged afterwards. */
  draw(place: FloorPose, look: FrameAppearance): void {
    const { view, cell, viewer } = this;
    const { renderer } = view.canvas;
    const { scene } = view.runScene;
    const frame = view.displayed;
    renderer.getClearColor(this.background);
    viewer.position.set(place.x_m, 0, place.z_m);
    viewer.rotation.y = place.turn;
    this.xrPaths.show(view.layer, look, frame?.instants.map(({ linkPoses }) => linkPoses.work) ?? []);
    // They are placed for the camera of the page.
    view.runScene.directions.group.visible = false;
    view.runScene.follow(this.lamp);
    cell.add(scene);
    this.scene.updateMatrixWorld(true);
    const target = renderer.getRenderTarget();
    // The page also draws without three.js, which does not know about that.
    renderer.resetState();
    renderer.setRenderTarget(target);
    renderer.render(this.scene, this.camera);
    cell.remove(scene);
    scene.updateMatrixWorld(true);
  }

  dispose(): void {
    this.xrPaths.dispose();
    this.floor.geometry.dispose(); // it has the material of the grid
  }
}
