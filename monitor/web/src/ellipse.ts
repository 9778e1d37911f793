// monitor/web/src/ellipse.ts: a covariance as the ellipse that holds 95 % of it.

/** Semi-axes in the covariance's unit; `angle` of the longer one, counter-clockwise, radians. */
export interface Ellipse {
  major: number;
  minor: number;
  angle: number;
}

/** Chi-square with two degrees of freedom stays below this with 95 %. */
const CHI2_95 = 5.991;

/**
 * The 95 % ellipse of a 2x2 covariance.
 *
 * @returns nothing if the matrix is not positive definite or not finite: then there is none
 */
export function ellipseOf(xx: number, xy: number, yy: number): Ellipse | undefined {
  const mean = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  const large = mean + spread;
  const small = mean - spread;
  if (!(small > 0) || !Number.isFinite(large)) return undefined;
  return {
    major: Math.sqrt(CHI2_95 * large),
    minor: Math.sqrt(CHI2_95 * small),
    angle: Math.atan2(2 * xy, xx - yy) / 2,
  };
}
