import type { Scene } from 'phaser';
import { vi } from 'vitest';

/** What a fake scene has, to look at and to play with. */
export interface FakeScene {
  readonly scene: Scene;
  readonly events: Emitter;
  readonly input: Emitter;
  readonly gamepad: Emitter;
  /** The game objects that exist. */
  readonly alive: ReadonlySet<FakeObject>;
  /** A frame at a time of the clock, ms. `delta` is what Phaser would smooth. */
  frame(time: number, delta?: number): void;
  /** Listeners on everything that a runner may listen to. */
  listeners(): number;
}

/** An emitter like Phaser's: listeners have a context. */
export class Emitter {
  private readonly all: { name: string; call: (...parts: unknown[]) => void; context: unknown; once: boolean }[] = [];

  get count(): number {
    return this.all.length;
  }

  on(name: string, call: (...parts: unknown[]) => void, context: unknown = null): this {
    this.all.push({ name, call, context, once: false });
    return this;
  }

  once(name: string, call: (...parts: unknown[]) => void, context: unknown = null): this {
    this.all.push({ name, call, context, once: true });
    return this;
  }

  off(name: string, call: unknown, context: unknown = null): this {
    const i = this.all.findIndex((one) => one.name === name && one.call === call && one.context === context);
    if (i >= 0) this.all.splice(i, 1);
    return this;
  }

  emit(name: string, ...parts: unknown[]): void {
    for (const one of [...this.all]) {
      if (one.name !== name || !this.all.includes(one)) continue;
      if (one.once) this.off(name, one.call, one.context);
      one.call.apply(one.context, parts);
    }
  }
}

/** A game object that remembers what is set. Setters of Phaser return the object. */
export class FakeObject {
  x = 0;
  y = 0;
  depth = 0;
  scale = 1;
  alpha = 1;
  rotation = 0;
  visible = true;
  scrollFactor = 1;
  children: FakeObject[] = [];

  constructor(
    private readonly alive: Set<FakeObject>,
    public texture = '',
  ) {
    alive.add(this);
  }

  setPosition(x: number, y: number): this {
    this.x = x;
    this.y = y;
    return this;
  }

  setDepth(depth: number): this {
    this.depth = depth;
    return this;
  }

  setScale(x: number): this {
    this.scale = x;
    return this;
  }

  setAlpha(alpha: number): this {
    this.alpha = alpha;
    return this;
  }

  setRotation(rotation: number): this {
    this.rotation = rotation;
    return this;
  }

  setVisible(visible: boolean): this {
    this.visible = visible;
    return this;
  }

  setTexture(texture: string): this {
    this.texture = texture;
    return this;
  }

  setOrigin(): this {
    return this;
  }

  setScrollFactor(factor: number): this {
    this.scrollFactor = factor;
    return this;
  }

  add(child: FakeObject | FakeObject[]): this {
    this.children.push(...(Array.isArray(child) ? child : [child]));
    return this;
  }

  sort(): this {
    this.children.sort((one, other) => one.depth - other.depth);
    return this;
  }

  destroy(): void {
    this.alive.delete(this);
    for (const child of this.children) child.destroy();
  }
}

/** The page that a runner listens to. */
export class FakePage {
  readonly window = new CountingTarget();
  readonly document = Object.assign(new CountingTarget(), { hidden: false });

  install(): void {
    vi.stubGlobal('window', this.window);
    vi.stubGlobal('document', this.document);
  }

  key(type: 'keydown' | 'keyup', code: string, more: object = {}): Event {
    const event = new Event(type, { cancelable: true });
    Object.assign(event, { code, key: code, repeat: false, ctrlKey: false, altKey: false, metaKey: false, ...more });
    this.window.dispatchEvent(event);
    return event;
  }

  hide(hidden: boolean): void {
    this.document.hidden = hidden;
    this.document.dispatchEvent(new Event('visibilitychange'));
  }
}

class CountingTarget extends EventTarget {
  count = 0;

  override addEventListener(...parts: Parameters<EventTarget['addEventListener']>): void {
    this.count++;
    super.addEventListener(...parts);
  }

  override removeEventListener(...parts: Parameters<EventTarget['removeEventListener']>): void {
    this.count--;
    super.removeEventListener(...parts);
  }
}

/** A scene with what both majors of Phaser have, of which only a runner's needs work. */
export function fakeScene(page: FakePage, more: object = {}): FakeScene {
  const alive = new Set<FakeObject>();
  const events = new Emitter();
  const gamepad = new Emitter();
  const input = Object.assign(new Emitter(), { enabled: true, gamepad });
  const scale = new Emitter();
  const add = {
    image: (_x: number, _y: number, texture: string) => new FakeObject(alive, texture),
    rectangle: () => new FakeObject(alive),
    container: (_x?: number, _y?: number, children: FakeObject[] = []) => new FakeObject(alive).add(children),
  };
  // every texture exists: there is no canvas to draw one on
  const textures = { exists: () => true, addCanvas: () => null, get: () => ({ setFilter() {} }) };
  const cameras = { main: { x: 0, y: 0, width: 800, height: 600, zoom: 1, scrollX: 0, scrollY: 0 } };
  const sys = { events, displayList: {}, textures, isActive: () => true };
  return {
    scene: { sys, add, textures, cameras, input, scale, ...more } as unknown as Scene,
    events,
    input,
    gamepad,
    alive,
    frame: (time, delta = 16) => events.emit('update', time, delta),
    listeners: () => [events, input, gamepad, scale, page.window, page.document].reduce((sum, { count }) => sum + count, 0),
  };
}

/** A pointer of Phaser: a mouse with its main button, or a finger. */
export const fakePointer = (id: number, { touch = false, x = 400, y = 300 } = {}) => ({
  id,
  x,
  y,
  wasTouch: touch,
  isDown: true,
  primaryDown: !touch,
});
