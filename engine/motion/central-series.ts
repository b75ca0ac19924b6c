/**
 * Power series, to degree 16, of u'' = alpha u / |u| + beta u: a pull or push of constant strength along u, and one
 * proportional to u.
 *
 * Let d = |u| and s = u.u. Energy is conserved, so s'' = 2 v.v + 2 u.u'' satisfies s'' = 6 alpha d + 4 beta s + constant, and s
 * follows from d alone. Then d follows from d d = s, and z = u / d from d z = u. Each coefficient takes 2 n products; s, 1 / d
 * and u / d as plain Cauchy products (Jorba and Zou 2005, prop. 1) would take 5 n. The products are written out because no
 * JavaScript engine unrolls loops this short; that saves two thirds of the time.
 *
 * On entry x[0..1], y[0..1] hold the place (not the centre) and the velocity, px and px/s. On return they hold all
 * coefficients.
 * @param alpha - px/s²
 * @param beta - 1/s²
 * @param px - if given, coefficients of a body with p'' = kappa u / |u| (the target's recoil); computed from the second on
 * @param py - likewise
 */
// biome-ignore format: a line for each coefficient
export function centralSeries(
  x: Float64Array, y: Float64Array, alpha: number, beta: number, px: Float64Array | null, py: Float64Array | null, kappa: number,
): void {
  const x0 = x[0];
  const y0 = y[0];
  const x1 = x[1];
  const y1 = y[1];
  const s0 = x0 * x0 + y0 * y0;
  const d0 = Math.sqrt(s0);
  const s1 = 2 * (x0 * x1 + y0 * y1);
  const s2 = x1 * x1 + y1 * y1 + alpha * d0 + beta * s0;
  const w = 1 / d0;
  const half = 0.5 * w;
  const alpha6 = 6 * alpha;
  const beta4 = 4 * beta;
  // n = 0
  const zx0 = x0 * w;
  const zy0 = y0 * w;
  const x2 = (alpha * zx0 + beta * x0) * (1 / 2);
  const y2 = (alpha * zy0 + beta * y0) * (1 / 2);
  // n = 1
  const d1 = s1 * half;
  const zx1 = (x1 - d1 * zx0) * w;
  const zy1 = (y1 - d1 * zy0) * w;
  const x3 = (alpha * zx1 + beta * x1) * (1 / 6);
  const y3 = (alpha * zy1 + beta * y1) * (1 / 6);
  const s3 = (alpha6 * d1 + beta4 * s1) * (1 / 6);
  // n = 2
  const d2 = (s2 - d1 * d1) * half;
  const zx2 = (x2 - (d1 * zx1 + d2 * zx0)) * w;
  const zy2 = (y2 - (d1 * zy1 + d2 * zy0)) * w;
  const x4 = (alpha * zx2 + beta * x2) * (1 / 12);
  const y4 = (alpha * zy2 + beta * y2) * (1 / 12);
  const s4 = (alpha6 * d2 + beta4 * s2) * (1 / 12);
  // n = 3
  const d3 = (s3 - 2 * d1 * d2) * half;
  const zx3 = (x3 - (d1 * zx2 + d2 * zx1 + d3 * zx0)) * w;
  const zy3 = (y3 - (d1 * zy2 + d2 * zy1 + d3 * zy0)) * w;
  const x5 = (alpha * zx3 + beta * x3) * (1 / 20);
  const y5 = (alpha * zy3 + beta * y3) * (1 / 20);
  const s5 = (alpha6 * d3 + beta4 * s3) * (1 / 20);
  // n = 4
  const d4 = (s4 - 2 * d1 * d3 - d2 * d2) * half;
  const zx4 = (x4 - (d1 * zx3 + d2 * zx2 + d3 * zx1 + d4 * zx0)) * w;
  const zy4 = (y4 - (d1 * zy3 + d2 * zy2 + d3 * zy1 + d4 * zy0)) * w;
  const x6 = (alpha * zx4 + beta * x4) * (1 / 30);
  const y6 = (alpha * zy4 + beta * y4) * (1 / 30);
  const s6 = (alpha6 * d4 + beta4 * s4) * (1 / 30);
  // n = 5
  const d5 = (s5 - 2 * (d1 * d4 + d2 * d3)) * half;
  const zx5 = (x5 - (d1 * zx4 + d2 * zx3 + d3 * zx2 + d4 * zx1 + d5 * zx0)) * w;
  const zy5 = (y5 - (d1 * zy4 + d2 * zy3 + d3 * zy2 + d4 * zy1 + d5 * zy0)) * w;
  const x7 = (alpha * zx5 + beta * x5) * (1 / 42);
  const y7 = (alpha * zy5 + beta * y5) * (1 / 42);
  const s7 = (alpha6 * d5 + beta4 * s5) * (1 / 42);
  // n = 6
  const d6 = (s6 - 2 * (d1 * d5 + d2 * d4) - d3 * d3) * half;
  const zx6 = (x6 - (d1 * zx5 + d2 * zx4 + d3 * zx3 + d4 * zx2 + d5 * zx1 + d6 * zx0)) * w;
  const zy6 = (y6 - (d1 * zy5 + d2 * zy4 + d3 * zy3 + d4 * zy2 + d5 * zy1 + d6 * zy0)) * w;
  const x8 = (alpha * zx6 + beta * x6) * (1 / 56);
  const y8 = (alpha * zy6 + beta * y6) * (1 / 56);
  const s8 = (alpha6 * d6 + beta4 * s6) * (1 / 56);
  // n = 7
  const d7 = (s7 - 2 * (d1 * d6 + d2 * d5 + d3 * d4)) * half;
  const zx7 = (x7 - (d1 * zx6 + d2 * zx5 + d3 * zx4 + d4 * zx3 + d5 * zx2 + d6 * zx1 + d7 * zx0)) * w;
  const zy7 = (y7 - (d1 * zy6 + d2 * zy5 + d3 * zy4 + d4 * zy3 + d5 * zy2 + d6 * zy1 + d7 * zy0)) * w;
  const x9 = (alpha * zx7 + beta * x7) * (1 / 72);
  const y9 = (alpha * zy7 + beta * y7) * (1 / 72);
  const s9 = (alpha6 * d7 + beta4 * s7) * (1 / 72);
  // n = 8
  const d8 = (s8 - 2 * (d1 * d7 + d2 * d6 + d3 * d5) - d4 * d4) * half;
  const zx8 = (x8 - (d1 * zx7 + d2 * zx6 + d3 * zx5 + d4 * zx4 + d5 * zx3 + d6 * zx2 + d7 * zx1 + d8 * zx0)) * w;
  const zy8 = (y8 - (d1 * zy7 + d2 * zy6 + d3 * zy5 + d4 * zy4 + d5 * zy3 + d6 * zy2 + d7 * zy1 + d8 * zy0)) * w;
  const x10 = (alpha * zx8 + beta * x8) * (1 / 90);
  const y10 = (alpha * zy8 + beta * y8) * (1 / 90);
  const s10 = (alpha6 * d8 + beta4 * s8) * (1 / 90);
  // n = 9
  const d9 = (s9 - 2 * (d1 * d8 + d2 * d7 + d3 * d6 + d4 * d5)) * half;
  const zx9 = (x9 - (d1 * zx8 + d2 * zx7 + d3 * zx6 + d4 * zx5 + d5 * zx4 + d6 * zx3 + d7 * zx2 + d8 * zx1 + d9 * zx0)) * w;
  const zy9 = (y9 - (d1 * zy8 + d2 * zy7 + d3 * zy6 + d4 * zy5 + d5 * zy4 + d6 * zy3 + d7 * zy2 + d8 * zy1 + d9 * zy0)) * w;
  const x11 = (alpha * zx9 + beta * x9) * (1 / 110);
  const y11 = (alpha * zy9 + beta * y9) * (1 / 110);
  const s11 = (alpha6 * d9 + beta4 * s9) * (1 / 110);
  // n = 10
  const d10 = (s10 - 2 * (d1 * d9 + d2 * d8 + d3 * d7 + d4 * d6) - d5 * d5) * half;
  const zx10 = (x10 - (d1 * zx9 + d2 * zx8 + d3 * zx7 + d4 * zx6 + d5 * zx5 + d6 * zx4 + d7 * zx3 + d8 * zx2 + d9 * zx1 + d10 * zx0)) * w;
  const zy10 = (y10 - (d1 * zy9 + d2 * zy8 + d3 * zy7 + d4 * zy6 + d5 * zy5 + d6 * zy4 + d7 * zy3 + d8 * zy2 + d9 * zy1 + d10 * zy0)) * w;
  const x12 = (alpha * zx10 + beta * x10) * (1 / 132);
  const y12 = (alpha * zy10 + beta * y10) * (1 / 132);
  const s12 = (alpha6 * d10 + beta4 * s10) * (1 / 132);
  // n = 11
  const d11 = (s11 - 2 * (d1 * d10 + d2 * d9 + d3 * d8 + d4 * d7 + d5 * d6)) * half;
  const zx11 = (x11 - (d1 * zx10 + d2 * zx9 + d3 * zx8 + d4 * zx7 + d5 * zx6 + d6 * zx5 + d7 * zx4 + d8 * zx3 + d9 * zx2 + d10 * zx1 + d11 * zx0)) * w;
  const zy11 = (y11 - (d1 * zy10 + d2 * zy9 + d3 * zy8 + d4 * zy7 + d5 * zy6 + d6 * zy5 + d7 * zy4 + d8 * zy3 + d9 * zy2 + d10 * zy1 + d11 * zy0)) * w;
  const x13 = (alpha * zx11 + beta * x11) * (1 / 156);
  const y13 = (alpha * zy11 + beta * y11) * (1 / 156);
  const s13 = (alpha6 * d11 + beta4 * s11) * (1 / 156);
  // n = 12
  const d12 = (s12 - 2 * (d1 * d11 + d2 * d10 + d3 * d9 + d4 * d8 + d5 * d7) - d6 * d6) * half;
  const zx12 = (x12 - (d1 * zx11 + d2 * zx10 + d3 * zx9 + d4 * zx8 + d5 * zx7 + d6 * zx6 + d7 * zx5 + d8 * zx4 + d9 * zx3 + d10 * zx2 + d11 * zx1 + d12 * zx0)) * w;
  const zy12 = (y12 - (d1 * zy11 + d2 * zy10 + d3 * zy9 + d4 * zy8 + d5 * zy7 + d6 * zy6 + d7 * zy5 + d8 * zy4 + d9 * zy3 + d10 * zy2 + d11 * zy1 + d12 * zy0)) * w;
  const x14 = (alpha * zx12 + beta * x12) * (1 / 182);
  const y14 = (alpha * zy12 + beta * y12) * (1 / 182);
  const s14 = (alpha6 * d12 + beta4 * s12) * (1 / 182);
  // n = 13
  const d13 = (s13 - 2 * (d1 * d12 + d2 * d11 + d3 * d10 + d4 * d9 + d5 * d8 + d6 * d7)) * half;
  const zx13 = (x13 - (d1 * zx12 + d2 * zx11 + d3 * zx10 + d4 * zx9 + d5 * zx8 + d6 * zx7 + d7 * zx6 + d8 * zx5 + d9 * zx4 + d10 * zx3 + d11 * zx2 + d12 * zx1 + d13 * zx0)) * w;
  const zy13 = (y13 - (d1 * zy12 + d2 * zy11 + d3 * zy10 + d4 * zy9 + d5 * zy8 + d6 * zy7 + d7 * zy6 + d8 * zy5 + d9 * zy4 + d10 * zy3 + d11 * zy2 + d12 * zy1 + d13 * zy0)) * w;
  const x15 = (alpha * zx13 + beta * x13) * (1 / 210);
  const y15 = (alpha * zy13 + beta * y13) * (1 / 210);
  // n = 14
  const d14 = (s14 - 2 * (d1 * d13 + d2 * d12 + d3 * d11 + d4 * d10 + d5 * d9 + d6 * d8) - d7 * d7) * half;
  const zx14 = (x14 - (d1 * zx13 + d2 * zx12 + d3 * zx11 + d4 * zx10 + d5 * zx9 + d6 * zx8 + d7 * zx7 + d8 * zx6 + d9 * zx5 + d10 * zx4 + d11 * zx3 + d12 * zx2 + d13 * zx1 + d14 * zx0)) * w;
  const zy14 = (y14 - (d1 * zy13 + d2 * zy12 + d3 * zy11 + d4 * zy10 + d5 * zy9 + d6 * zy8 + d7 * zy7 + d8 * zy6 + d9 * zy5 + d10 * zy4 + d11 * zy3 + d12 * zy2 + d13 * zy1 + d14 * zy0)) * w;
  const x16 = (alpha * zx14 + beta * x14) * (1 / 240);
  const y16 = (alpha * zy14 + beta * y14) * (1 / 240);
  x[2] = x2;
  y[2] = y2;
  x[3] = x3;
  y[3] = y3;
  x[4] = x4;
  y[4] = y4;
  x[5] = x5;
  y[5] = y5;
  x[6] = x6;
  y[6] = y6;
  x[7] = x7;
  y[7] = y7;
  x[8] = x8;
  y[8] = y8;
  x[9] = x9;
  y[9] = y9;
  x[10] = x10;
  y[10] = y10;
  x[11] = x11;
  y[11] = y11;
  x[12] = x12;
  y[12] = y12;
  x[13] = x13;
  y[13] = y13;
  x[14] = x14;
  y[14] = y14;
  x[15] = x15;
  y[15] = y15;
  x[16] = x16;
  y[16] = y16;
  if (px === null || py === null) return;
  px[2] = kappa * (1 / 2) * zx0;
  py[2] = kappa * (1 / 2) * zy0;
  px[3] = kappa * (1 / 6) * zx1;
  py[3] = kappa * (1 / 6) * zy1;
  px[4] = kappa * (1 / 12) * zx2;
  py[4] = kappa * (1 / 12) * zy2;
  px[5] = kappa * (1 / 20) * zx3;
  py[5] = kappa * (1 / 20) * zy3;
  px[6] = kappa * (1 / 30) * zx4;
  py[6] = kappa * (1 / 30) * zy4;
  px[7] = kappa * (1 / 42) * zx5;
  py[7] = kappa * (1 / 42) * zy5;
  px[8] = kappa * (1 / 56) * zx6;
  py[8] = kappa * (1 / 56) * zy6;
  px[9] = kappa * (1 / 72) * zx7;
  py[9] = kappa * (1 / 72) * zy7;
  px[10] = kappa * (1 / 90) * zx8;
  py[10] = kappa * (1 / 90) * zy8;
  px[11] = kappa * (1 / 110) * zx9;
  py[11] = kappa * (1 / 110) * zy9;
  px[12] = kappa * (1 / 132) * zx10;
  py[12] = kappa * (1 / 132) * zy10;
  px[13] = kappa * (1 / 156) * zx11;
  py[13] = kappa * (1 / 156) * zy11;
  px[14] = kappa * (1 / 182) * zx12;
  py[14] = kappa * (1 / 182) * zy12;
  px[15] = kappa * (1 / 210) * zx13;
  py[15] = kappa * (1 / 210) * zy13;
  px[16] = kappa * (1 / 240) * zx14;
  py[16] = kappa * (1 / 240) * zy14;
}
