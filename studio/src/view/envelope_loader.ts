// Requests the reach of the tool from the engine when it is to be shown, and again if it may have changed.

import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import type { View } from "./view";

/** `say` shows a message to the user; empty: clears it. */
export function watchEnvelope(store: Store, session: Session, view: View, say: (text: string) => void): void {
  const { envelope } = view.runScene;
  let asked = 0;
  const show = async (): Promise<void> => {
    const own = ++asked;
    envelope.group.visible = false;
    envelope.clear();
    say("");
    view.invalidate();
    if (!store.get("showEnvelope")) return;
    const bytes = await session.envelope();
    // The result is of an earlier machine, or not to be shown any more.
    if (own !== asked) return;
    say(bytes ? "" : texts.view.noEnvelope);
    if (!bytes) return;
    envelope.setContent(bytes);
    envelope.group.visible = true;
    view.rig.setVisibleBounds(view.runScene.fullBox().expandByScalar(2000));
    view.invalidate();
  };
  store.watch(["showEnvelope"], () => void show());
  session.on(() => void show());
}
