// Math.sin and its like differ between engines in the last digit, so that the same level could have a proof in one and none in
// another. These are series, exact to about 1e-15, of + - * / alone.

const PI = Math.PI;

/** Cosine of an angle, rad. */
export const cos = (angle: number): number => sin(angle + PI / 2);

/** Sine of an angle, rad. */
export function sin(angle: number): number {
  let x = angle - 2 * PI * Math.round(angle / (2 * PI));
  if (x > PI / 2) x = PI - x;
  else if (x < -PI / 2) x = -PI - x;
  const q = x * x;
  let sum = 0;
  // Horner's scheme of x - x³/3! + x⁵/5! ...
  for (let n = 21; n >= 3; n -= 2) sum = (-q / (n * (n - 1))) * (1 + sum);
  return x * (1 + sum);
}

/** The angle of a vector, -pi to pi; 0 for the zero vector. */
export function atan2(y: number, x: number): number {
  const a = Math.abs(x);
  const b = Math.abs(y);
  if (a === 0 && b === 0) return 0;
  let angle = b <= a ? arctangent(b / a) : PI / 2 - arctangent(a / b);
  if (x < 0) angle = PI - angle;
  return y < 0 ? -angle : angle;
}

/** Arc tangent of a number from 0 to 1. */
function arctangent(t: number): number {
  // Halving the angle twice makes the series short.
  const half = t / (1 + Math.sqrt(1 + t * t));
  const x = half / (1 + Math.sqrt(1 + half * half));
  const q = x * x;
  let sum = 0;
  for (let n = 23; n >= 1; n -= 2) sum = 1 / n - q * sum;
  return 4 * x * sum;
}
