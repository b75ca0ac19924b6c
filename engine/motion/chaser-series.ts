/** A body this near to her touches her, so the run has ended, px². Terms that divide by the distance would overflow. */
const TOUCHING = 1e-12;

/**
 * Power series, to degree 16, of a body q that accelerates towards a moving place a: q'' = kappa (a - q) / |a - q|.
 *
 * Let e = a - q, s = e.e and d = |e|. Then d follows from d d = s, and z = e / d from d z = e, as in {@link centralSeries}.
 * Energy is not conserved here, so s is a Cauchy product. The products are written out for the same reason.
 *
 * On entry qx[0..1], qy[0..1] hold place and velocity, px and px/s. On return they hold all coefficients.
 * @param ax - coefficients of the place that it chases, to degree 14 at least
 * @param ay - likewise
 * @param kappa - px/s²
 */
// biome-ignore format: a line for each coefficient
export function chaserSeries(
  qx: Float64Array, qy: Float64Array, ax: Float64Array, ay: Float64Array, kappa: number,
): void {
  const dx0 = ax[0] - qx[0];
  const dy0 = ay[0] - qy[0];
  const dx1 = ax[1] - qx[1];
  const dy1 = ay[1] - qy[1];
  const s0 = dx0 * dx0 + dy0 * dy0;
  if (s0 < TOUCHING) {
    qx.fill(0, 2);
    qy.fill(0, 2);
    return;
  }
  const w = 1 / Math.sqrt(s0);
  const half = 0.5 * w;
  // n = 0
  const zx0 = dx0 * w;
  const zy0 = dy0 * w;
  const x2 = kappa * (1 / 2) * zx0;
  const y2 = kappa * (1 / 2) * zy0;
  // n = 1
  const s1 = 2 * (dx0 * dx1 + dy0 * dy1);
  const d1 = s1 * half;
  const zx1 = (dx1 - d1 * zx0) * w;
  const zy1 = (dy1 - d1 * zy0) * w;
  const x3 = kappa * (1 / 6) * zx1;
  const y3 = kappa * (1 / 6) * zy1;
  // n = 2
  const dx2 = ax[2] - x2;
  const dy2 = ay[2] - y2;
  const s2 = 2 * (dx0 * dx2 + dy0 * dy2) + (dx1 * dx1 + dy1 * dy1);
  const d2 = (s2 - d1 * d1) * half;
  const zx2 = (dx2 - (d1 * zx1 + d2 * zx0)) * w;
  const zy2 = (dy2 - (d1 * zy1 + d2 * zy0)) * w;
  const x4 = kappa * (1 / 12) * zx2;
  const y4 = kappa * (1 / 12) * zy2;
  // n = 3
  const dx3 = ax[3] - x3;
  const dy3 = ay[3] - y3;
  const s3 = 2 * (dx0 * dx3 + dy0 * dy3 + dx1 * dx2 + dy1 * dy2);
  const d3 = (s3 - 2 * d1 * d2) * half;
  const zx3 = (dx3 - (d1 * zx2 + d2 * zx1 + d3 * zx0)) * w;
  const zy3 = (dy3 - (d1 * zy2 + d2 * zy1 + d3 * zy0)) * w;
  const x5 = kappa * (1 / 20) * zx3;
  const y5 = kappa * (1 / 20) * zy3;
  // n = 4
  const dx4 = ax[4] - x4;
  const dy4 = ay[4] - y4;
  const s4 = 2 * (dx0 * dx4 + dy0 * dy4 + dx1 * dx3 + dy1 * dy3) + (dx2 * dx2 + dy2 * dy2);
  const d4 = (s4 - 2 * d1 * d3 - d2 * d2) * half;
  const zx4 = (dx4 - (d1 * zx3 + d2 * zx2 + d3 * zx1 + d4 * zx0)) * w;
  const zy4 = (dy4 - (d1 * zy3 + d2 * zy2 + d3 * zy1 + d4 * zy0)) * w;
  const x6 = kappa * (1 / 30) * zx4;
  const y6 = kappa * (1 / 30) * zy4;
  // n = 5
  const dx5 = ax[5] - x5;
  const dy5 = ay[5] - y5;
  const s5 = 2 * (dx0 * dx5 + dy0 * dy5 + dx1 * dx4 + dy1 * dy4 + dx2 * dx3 + dy2 * dy3);
  const d5 = (s5 - 2 * (d1 * d4 + d2 * d3)) * half;
  const zx5 = (dx5 - (d1 * zx4 + d2 * zx3 + d3 * zx2 + d4 * zx1 + d5 * zx0)) * w;
  const zy5 = (dy5 - (d1 * zy4 + d2 * zy3 + d3 * zy2 + d4 * zy1 + d5 * zy0)) * w;
  const x7 = kappa * (1 / 42) * zx5;
  const y7 = kappa * (1 / 42) * zy5;
  // n = 6
  const dx6 = ax[6] - x6;
  const dy6 = ay[6] - y6;
  const s6 = 2 * (dx0 * dx6 + dy0 * dy6 + dx1 * dx5 + dy1 * dy5 + dx2 * dx4 + dy2 * dy4) + (dx3 * dx3 + dy3 * dy3);
  const d6 = (s6 - 2 * (d1 * d5 + d2 * d4) - d3 * d3) * half;
  const zx6 = (dx6 - (d1 * zx5 + d2 * zx4 + d3 * zx3 + d4 * zx2 + d5 * zx1 + d6 * zx0)) * w;
  const zy6 = (dy6 - (d1 * zy5 + d2 * zy4 + d3 * zy3 + d4 * zy2 + d5 * zy1 + d6 * zy0)) * w;
  const x8 = kappa * (1 / 56) * zx6;
  const y8 = kappa * (1 / 56) * zy6;
  // n = 7
  const dx7 = ax[7] - x7;
  const dy7 = ay[7] - y7;
  const s7 = 2 * (dx0 * dx7 + dy0 * dy7 + dx1 * dx6 + dy1 * dy6 + dx2 * dx5 + dy2 * dy5 + dx3 * dx4 + dy3 * dy4);
  const d7 = (s7 - 2 * (d1 * d6 + d2 * d5 + d3 * d4)) * half;
  const zx7 = (dx7 - (d1 * zx6 + d2 * zx5 + d3 * zx4 + d4 * zx3 + d5 * zx2 + d6 * zx1 + d7 * zx0)) * w;
  const zy7 = (dy7 - (d1 * zy6 + d2 * zy5 + d3 * zy4 + d4 * zy3 + d5 * zy2 + d6 * zy1 + d7 * zy0)) * w;
  const x9 = kappa * (1 / 72) * zx7;
  const y9 = kappa * (1 / 72) * zy7;
  // n = 8
  const dx8 = ax[8] - x8;
  const dy8 = ay[8] - y8;
  const s8 = 2 * (dx0 * dx8 + dy0 * dy8 + dx1 * dx7 + dy1 * dy7 + dx2 * dx6 + dy2 * dy6 + dx3 * dx5 + dy3 * dy5) + (dx4 * dx4 + dy4 * dy4);
  const d8 = (s8 - 2 * (d1 * d7 + d2 * d6 + d3 * d5) - d4 * d4) * half;
  const zx8 = (dx8 - (d1 * zx7 + d2 * zx6 + d3 * zx5 + d4 * zx4 + d5 * zx3 + d6 * zx2 + d7 * zx1 + d8 * zx0)) * w;
  const zy8 = (dy8 - (d1 * zy7 + d2 * zy6 + d3 * zy5 + d4 * zy4 + d5 * zy3 + d6 * zy2 + d7 * zy1 + d8 * zy0)) * w;
  const x10 = kappa * (1 / 90) * zx8;
  const y10 = kappa * (1 / 90) * zy8;
  // n = 9
  const dx9 = ax[9] - x9;
  const dy9 = ay[9] - y9;
  const s9 = 2 * (dx0 * dx9 + dy0 * dy9 + dx1 * dx8 + dy1 * dy8 + dx2 * dx7 + dy2 * dy7 + dx3 * dx6 + dy3 * dy6 + dx4 * dx5 + dy4 * dy5);
  const d9 = (s9 - 2 * (d1 * d8 + d2 * d7 + d3 * d6 + d4 * d5)) * half;
  const zx9 = (dx9 - (d1 * zx8 + d2 * zx7 + d3 * zx6 + d4 * zx5 + d5 * zx4 + d6 * zx3 + d7 * zx2 + d8 * zx1 + d9 * zx0)) * w;
  const zy9 = (dy9 - (d1 * zy8 + d2 * zy7 + d3 * zy6 + d4 * zy5 + d5 * zy4 + d6 * zy3 + d7 * zy2 + d8 * zy1 + d9 * zy0)) * w;
  const x11 = kappa * (1 / 110) * zx9;
  const y11 = kappa * (1 / 110) * zy9;
  // n = 10
  const dx10 = ax[10] - x10;
  const dy10 = ay[10] - y10;
  const s10 = 2 * (dx0 * dx10 + dy0 * dy10 + dx1 * dx9 + dy1 * dy9 + dx2 * dx8 + dy2 * dy8 + dx3 * dx7 + dy3 * dy7 + dx4 * dx6 + dy4 * dy6) + (dx5 * dx5 + dy5 * dy5);
  const d10 = (s10 - 2 * (d1 * d9 + d2 * d8 + d3 * d7 + d4 * d6) - d5 * d5) * half;
  const zx10 = (dx10 - (d1 * zx9 + d2 * zx8 + d3 * zx7 + d4 * zx6 + d5 * zx5 + d6 * zx4 + d7 * zx3 + d8 * zx2 + d9 * zx1 + d10 * zx0)) * w;
  const zy10 = (dy10 - (d1 * zy9 + d2 * zy8 + d3 * zy7 + d4 * zy6 + d5 * zy5 + d6 * zy4 + d7 * zy3 + d8 * zy2 + d9 * zy1 + d10 * zy0)) * w;
  const x12 = kappa * (1 / 132) * zx10;
  const y12 = kappa * (1 / 132) * zy10;
  // n = 11
  const dx11 = ax[11] - x11;
  const dy11 = ay[11] - y11;
  const s11 = 2 * (dx0 * dx11 + dy0 * dy11 + dx1 * dx10 + dy1 * dy10 + dx2 * dx9 + dy2 * dy9 + dx3 * dx8 + dy3 * dy8 + dx4 * dx7 + dy4 * dy7 + dx5 * dx6 + dy5 * dy6);
  const d11 = (s11 - 2 * (d1 * d10 + d2 * d9 + d3 * d8 + d4 * d7 + d5 * d6)) * half;
  const zx11 = (dx11 - (d1 * zx10 + d2 * zx9 + d3 * zx8 + d4 * zx7 + d5 * zx6 + d6 * zx5 + d7 * zx4 + d8 * zx3 + d9 * zx2 + d10 * zx1 + d11 * zx0)) * w;
  const zy11 = (dy11 - (d1 * zy10 + d2 * zy9 + d3 * zy8 + d4 * zy7 + d5 * zy6 + d6 * zy5 + d7 * zy4 + d8 * zy3 + d9 * zy2 + d10 * zy1 + d11 * zy0)) * w;
  const x13 = kappa * (1 / 156) * zx11;
  const y13 = kappa * (1 / 156) * zy11;
  // n = 12
  const dx12 = ax[12] - x12;
  const dy12 = ay[12] - y12;
  const s12 = 2 * (dx0 * dx12 + dy0 * dy12 + dx1 * dx11 + dy1 * dy11 + dx2 * dx10 + dy2 * dy10 + dx3 * dx9 + dy3 * dy9 + dx4 * dx8 + dy4 * dy8 + dx5 * dx7 + dy5 * dy7) + (dx6 * dx6 + dy6 * dy6);
  const d12 = (s12 - 2 * (d1 * d11 + d2 * d10 + d3 * d9 + d4 * d8 + d5 * d7) - d6 * d6) * half;
  const zx12 = (dx12 - (d1 * zx11 + d2 * zx10 + d3 * zx9 + d4 * zx8 + d5 * zx7 + d6 * zx6 + d7 * zx5 + d8 * zx4 + d9 * zx3 + d10 * zx2 + d11 * zx1 + d12 * zx0)) * w;
  const zy12 = (dy12 - (d1 * zy11 + d2 * zy10 + d3 * zy9 + d4 * zy8 + d5 * zy7 + d6 * zy6 + d7 * zy5 + d8 * zy4 + d9 * zy3 + d10 * zy2 + d11 * zy1 + d12 * zy0)) * w;
  const x14 = kappa * (1 / 182) * zx12;
  const y14 = kappa * (1 / 182) * zy12;
  // n = 13
  const dx13 = ax[13] - x13;
  const dy13 = ay[13] - y13;
  const s13 = 2 * (dx0 * dx13 + dy0 * dy13 + dx1 * dx12 + dy1 * dy12 + dx2 * dx11 + dy2 * dy11 + dx3 * dx10 + dy3 * dy10 + dx4 * dx9 + dy4 * dy9 + dx5 * dx8 + dy5 * dy8 + dx6 * dx7 + dy6 * dy7);
  const d13 = (s13 - 2 * (d1 * d12 + d2 * d11 + d3 * d10 + d4 * d9 + d5 * d8 + d6 * d7)) * half;
  const zx13 = (dx13 - (d1 * zx12 + d2 * zx11 + d3 * zx10 + d4 * zx9 + d5 * zx8 + d6 * zx7 + d7 * zx6 + d8 * zx5 + d9 * zx4 + d10 * zx3 + d11 * zx2 + d12 * zx1 + d13 * zx0)) * w;
  const zy13 = (dy13 - (d1 * zy12 + d2 * zy11 + d3 * zy10 + d4 * zy9 + d5 * zy8 + d6 * zy7 + d7 * zy6 + d8 * zy5 + d9 * zy4 + d10 * zy3 + d11 * zy2 + d12 * zy1 + d13 * zy0)) * w;
  const x15 = kappa * (1 / 210) * zx13;
  const y15 = kappa * (1 / 210) * zy13;
  // n = 14
  const dx14 = ax[14] - x14;
  const dy14 = ay[14] - y14;
  const s14 = 2 * (dx0 * dx14 + dy0 * dy14 + dx1 * dx13 + dy1 * dy13 + dx2 * dx12 + dy2 * dy12 + dx3 * dx11 + dy3 * dy11 + dx4 * dx10 + dy4 * dy10 + dx5 * dx9 + dy5 * dy9 + dx6 * dx8 + dy6 * dy8) + (dx7 * dx7 + dy7 * dy7);
  const d14 = (s14 - 2 * (d1 * d13 + d2 * d12 + d3 * d11 + d4 * d10 + d5 * d9 + d6 * d8) - d7 * d7) * half;
  const zx14 = (dx14 - (d1 * zx13 + d2 * zx12 + d3 * zx11 + d4 * zx10 + d5 * zx9 + d6 * zx8 + d7 * zx7 + d8 * zx6 + d9 * zx5 + d10 * zx4 + d11 * zx3 + d12 * zx2 + d13 * zx1 + d14 * zx0)) * w;
  const zy14 = (dy14 - (d1 * zy13 + d2 * zy12 + d3 * zy11 + d4 * zy10 + d5 * zy9 + d6 * zy8 + d7 * zy7 + d8 * zy6 + d9 * zy5 + d10 * zy4 + d11 * zy3 + d12 * zy2 + d13 * zy1 + d14 * zy0)) * w;
  const x16 = kappa * (1 / 240) * zx14;
  const y16 = kappa * (1 / 240) * zy14;
  qx[2] = x2;
  qy[2] = y2;
  qx[3] = x3;
  qy[3] = y3;
  qx[4] = x4;
  qy[4] = y4;
  qx[5] = x5;
  qy[5] = y5;
  qx[6] = x6;
  qy[6] = y6;
  qx[7] = x7;
  qy[7] = y7;
  qx[8] = x8;
  qy[8] = y8;
  qx[9] = x9;
  qy[9] = y9;
  qx[10] = x10;
  qy[10] = y10;
  qx[11] = x11;
  qy[11] = y11;
  qx[12] = x12;
  qy[12] = y12;
  qx[13] = x13;
  qy[13] = y13;
  qx[14] = x14;
  qy[14] = y14;
  qx[15] = x15;
  qy[15] = y15;
  qx[16] = x16;
  qy[16] = y16;
}
