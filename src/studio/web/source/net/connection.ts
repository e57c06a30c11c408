// SPDX-License-Identifier: GPL-3.0-or-later
// The line to the program: the token's exchange, requests and replies over the WebSocket, uploads and downloads.
import { decodeFrame, patched, type Frame } from "./frame";
import type { Edit, Failure, ServerMessage, State } from "./messages";

export class RequestError extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

export interface Listener {
  state(state: State): void;
  frame(frame: Frame): void;
  layerGone(layer: string): void;
  progress(stage: string, fraction: number): void;
  trouble(message: string): void;
  connected(yes: boolean): void;
  preferences(kept: Record<string, unknown>): void;
}

/** Where the secret is kept: only pages of this origin, with its port, can read it. Servers of others at other ports are not sent it. */
const place = "reebquad-secret";

function secret(): string {
  return localStorage.getItem(place) ?? "";
}

function withSecret(): HeadersInit {
  return { Authorization: `Bearer ${secret()}` };
}

/** Whether what was kept from another visit still opens: then there is no such request, without it there is no access. */
async function isKnown(): Promise<boolean> {
  return secret() !== "" && (await fetch("/api/known", { headers: withSecret() })).status === 404;
}

/** Exchanges the token of the address for the secret, and removes it from the address bar and the history. */
export async function enter(): Promise<void> {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (!token) return;
  const answer = await fetch("/api/enter", { method: "POST", body: token });
  history.replaceState(null, "", "/");
  if (answer.ok) localStorage.setItem(place, ((await answer.json()) as { secret: string }).secret);
  else if (!(await isKnown()))
    throw new Error("The address was used already, is too old, or of another run. Press Enter where the program runs: it prints another.");
}

export class Connection {
  private socket: WebSocket | null = null;
  private nextId = 1;
  private attempts = 0;
  private waiting = new Map<number, { resolve: (value: unknown) => void; reject: (error: Error) => void }>();

  /** The newest state's revision, and who waits for one to come. */
  private revision = -1;
  private awaited: { revision: number; resolve: () => void; reject: (error: Error) => void }[] = [];

  /** The layers as they are, for messages that say what changed of them. */
  private layers = new Map<string, Frame>();

  constructor(private readonly listener: Listener) {}

  open(): void {
    this.layers.clear();
    this.revision = -1;
    const socket = new WebSocket(`ws://${location.host}/api/socket`, ["reebquad", secret()].filter((name) => name !== ""));
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.attempts = 0;
      this.listener.connected(true);
    };
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.take(event.data);
    socket.onclose = () => this.lost();
    this.socket = socket;
  }

  request(command: string, members: Record<string, unknown> = {}): Promise<unknown> {
    const id = this.nextId++;
    return new Promise((resolve, reject) => {
      if (this.socket?.readyState !== WebSocket.OPEN) return reject(new Error("The program does not answer."));
      this.waiting.set(id, { resolve, reject });
      this.socket.send(JSON.stringify({ id, command, ...members }));
    });
  }

  edit(edit: Edit, live = false): Promise<unknown> {
    return this.request("edit", { edit, live });
  }

  /** Sends a file; done when the state that it made has been taken. The answer comes by another way than the state, so either may be first. */
  async upload(file: File): Promise<void> {
    const answer = await fetch(`/api/upload?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file, headers: withSecret() });
    if (!answer.ok) throw new Error(await sentenceOf(answer));
    await this.stateOf(((await answer.json()) as { revision: number }).revision);
  }

  private stateOf(revision: number): Promise<void> {
    if (this.revision >= revision) return Promise.resolve();
    return new Promise((resolve, reject) => this.awaited.push({ revision, resolve, reject }));
  }

  async download(what: string): Promise<Blob> {
    const answer = await fetch(`/api/download?what=${encodeURIComponent(what)}`, { headers: withSecret() });
    if (!answer.ok) throw new Error(await sentenceOf(answer));
    return answer.blob();
  }

  private take(data: string | ArrayBuffer): void {
    if (data instanceof ArrayBuffer) return this.takeFrame(decodeFrame(data));
    const message = JSON.parse(data) as ServerMessage;
    if ("reply" in message) {
      const entry = this.waiting.get(message.reply);
      this.waiting.delete(message.reply);
      if (message.ok) entry?.resolve(message.result);
      else entry?.reject(new RequestError(message.error));
    } else if (message.event === "state") this.takeState(message);
    else if (message.event === "progress") this.listener.progress(message.stage, message.fraction);
    else if (message.event === "no_layer") this.listener.layerGone(message.layer);
    else if (message.event === "hello") this.listener.preferences(message.preferences ?? {});
    else if (message.event === "trouble") this.listener.trouble(message.message);
  }

  private takeState(state: State): void {
    this.revision = state.revision;
    this.listener.state(state);
    const come = this.awaited.filter((entry) => entry.revision <= state.revision);
    this.awaited = this.awaited.filter((entry) => entry.revision > state.revision);
    for (const { resolve } of come) resolve();
  }

  private takeFrame(message: Frame): void {
    const frame = patched(this.layers.get(message.layer), message);
    this.layers.set(frame.layer, frame);
    this.listener.frame(frame);
  }

  private lost(): void {
    this.listener.connected(false);
    for (const { reject } of [...this.waiting.values(), ...this.awaited]) reject(new Error("The connection to the program was lost."));
    this.waiting.clear();
    this.awaited = [];
    const delay = Math.min(5000, 250 * 2 ** this.attempts++);
    setTimeout(() => this.open(), delay);
  }
}

async function sentenceOf(answer: Response): Promise<string> {
  try {
    return ((await answer.json()) as { error: string }).error;
  } catch {
    return `The program answered ${answer.status}.`;
  }
}
