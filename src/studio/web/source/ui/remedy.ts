// SPDX-License-Identifier: GPL-3.0-or-later
// After a refusal: the nearest edit that works, as one button in the message that tells why. Pointed at, it shows what it would make.
import * as THREE from "three";
import { RequestError } from "../net/connection";
import type { Edit, Offer } from "../net/messages";
import { PlaceMark } from "../scene/place_mark";
import { Preview } from "../tools/preview";
import type { Workbench } from "../workbench";
import { h } from "./dom";
import { plain } from "./words";

const again = 400; // milliseconds until the program is asked once more, where something else came first

export class Remedy {
  private readonly mark: PlaceMark;
  private readonly preview: Preview;

  constructor(private readonly app: Workbench) {
    this.mark = new PlaceMark(app.viewport);
    this.preview = new Preview(app, () => {});
  }

  /** Asks what works in place of an edit, and puts it into the message, if that is still there. */
  async offer(refused: Edit, toast: HTMLElement): Promise<void> {
    if (!toast.isConnected) return;
    try {
      const offer = (await this.app.connection.request("offer", { edit: refused })) as Offer | null;
      if (offer && toast.isConnected) this.put(offer, toast);
    } catch (error) {
      if (error instanceof RequestError && error.failure.cancelled) setTimeout(() => void this.offer(refused, toast), again);
    }
  }

  private put(offer: Offer, toast: HTMLElement): void {
    const [x, y, z] = this.app.store.get("state")?.file?.origin ?? [0, 0, 0];
    const place = new THREE.Vector3(...offer.place).sub(new THREE.Vector3(x, y, z));
    const show = (): void => (this.mark.show(place), this.preview.show(offer.edit)), hide = (): void => (this.mark.show(null), this.preview.show(null));
    const take = async (): Promise<void> => {
      hide();
      toast.remove();
      await this.app.edit(offer.edit);
    };
    const button = h("button", { className: "primary small remedy", "data-offer": offer.edit.edit, onclick: () => void take(), onpointerenter: show, onpointerleave: hide, onfocus: show, onblur: hide }, plain(offer.words));
    toast.querySelector(".toast-text")!.append(button);
  }
}
