/**
 * The cubic of a step of length `h`, from what the step adds to straight motion. Working with the differences loses no digits.
 * @param gain - what the step adds to the place, x and y, and to the velocity, x and y
 */
export function cubicFrom(gain: Float64Array, x: Float64Array, y: Float64Array, h: number): void {
  const bendX = gain[0] / h;
  const bendY = gain[1] / h;
  x[2] = (3 * bendX - gain[2]) / h;
  y[2] = (3 * bendY - gain[3]) / h;
  x[3] = (gain[2] - 2 * bendX) / (h * h);
  y[3] = (gain[3] - 2 * bendY) / (h * h);
}
