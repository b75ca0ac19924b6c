// the package has no types: here is only what the peer uses
declare module 'matter-js' {
  export interface Vector {
    x: number;
    y: number;
  }
  export interface Body {
    readonly position: Readonly<Vector>;
    readonly positionPrev: Readonly<Vector>;
    readonly mass: number;
    force: Vector;
  }
  export interface BodyOptions {
    isSensor?: boolean;
    isStatic?: boolean;
    mass?: number;
    inertia?: number;
    friction?: number;
    frictionAir?: number;
  }
  export interface Engine {
    readonly world: object;
  }
  export interface CollisionEvent {
    readonly pairs: readonly { readonly bodyA: Body; readonly bodyB: Body }[];
  }
  const Matter: {
    Engine: {
      create(options: { gravity: { x: number; y: number; scale: number }; enableSleeping: boolean }): Engine;
      update(engine: Engine, deltaMs: number): void;
      clear(engine: Engine): void;
    };
    Bodies: {
      rectangle(x: number, y: number, width: number, height: number, options: BodyOptions): Body;
      circle(x: number, y: number, radius: number, options: BodyOptions): Body;
    };
    Body: {
      setAngle(body: Body, angle: number): void;
      /** px per 1/60 s */
      setVelocity(body: Body, velocity: Vector): void;
    };
    Composite: { add(world: object, body: Body): void };
    Events: { on(engine: Engine, name: 'collisionStart', callback: (event: CollisionEvent) => void): void };
  };
  export default Matter;
}
