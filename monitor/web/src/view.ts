// monitor/web/src/view.ts: from field coordinates to the drawing's.

/** Drawing units per metre: text gets poor below one unit, so that metres themselves do not serve. */
export const UNITS = 100;

export interface Place {
  x: number;
  y: number;
}

/** Which side the operator looks from. The drawing's y points down. */
export class View {
  constructor(readonly flipped: boolean) {}

  /** A floor point in F, metres, in drawing units. */
  place(x: number, y: number): Place {
    const sign = this.flipped ? -1 : 1;
    return { x: sign * x * UNITS, y: -sign * y * UNITS };
  }

  /** A direction in F, radians counter-clockwise, as an SVG rotation: degrees, clockwise, (-180, 180]. */
  rotation(angle: number): number {
    const degrees = -(angle * 180) / Math.PI + (this.flipped ? 180 : 0);
    const wrapped = ((degrees % 360) + 360) % 360;
    return wrapped > 180 ? wrapped - 360 : wrapped;
  }
}
