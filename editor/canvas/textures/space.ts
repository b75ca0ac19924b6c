import type { Colours } from '../colours.ts';
import { type Brush, dice, disc, fadingDisc, faint, ring } from './brush.ts';

/** A dwarf nova: a white heart, and rays that end at the unit circle, where it burns. */
export function drawNova(brush: Brush, colours: Colours): void {
  const rays = 24;
  brush.fillStyle = faint(colours.nova, 0.85);
  brush.beginPath();
  for (let i = 0; i < 2 * rays; i++) {
    const angle = (Math.PI * i) / rays;
    const out = i % 2 === 0 ? 1 : 0.78;
    brush.lineTo(out * Math.cos(angle), out * Math.sin(angle));
  }
  brush.closePath();
  brush.fill();
  fadingDisc(brush, 0.86, [
    [0, colours.novaCore],
    [0.35, colours.novaCore],
    [0.6, '#ffc35a'],
    [0.85, colours.nova],
    [1, faint(colours.nova, 0)],
  ]);
}

/** The black hole: nothing in the middle, and arms of light that wind into it. */
export function drawBlackHole(brush: Brush, colours: Colours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.holeRim, 0.9)],
    [0.5, faint(colours.holeRim, 0.5)],
    [1, faint(colours.holeRim, 0)],
  ]);
  brush.lineCap = 'round';
  for (let arm = 0; arm < 4; arm++) {
    for (let k = 0; k < 40; k++) {
      const share = k / 40;
      const out = 0.46 + 0.5 * share;
      const angle = (Math.PI / 2) * arm + 3.2 * share;
      brush.fillStyle = faint(k % 3 === 0 ? '#ffffff' : colours.holeRim, 0.75 * (1 - share));
      disc(brush, out * Math.cos(angle), out * Math.sin(angle), 0.075 * (1 - 0.6 * share));
    }
  }
  brush.fillStyle = colours.hole;
  disc(brush, 0, 0, 0.5);
  ring(brush, 0.5, 0.04, '#ffffff');
}

/** A repulsor: rings that go outwards. */
export function drawRepulsor(brush: Brush, colours: Colours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.field, 0.05)],
    [0.8, faint(colours.field, 0.16)],
    [1, faint(colours.field, 0.3)],
  ]);
  for (const out of [0.3, 0.55, 0.78]) ring(brush, out, 0.02, faint(colours.field, 0.35 + 0.4 * out));
  brush.strokeStyle = faint(colours.field, 0.9);
  brush.lineWidth = 0.035;
  brush.lineJoin = 'round';
  for (let i = 0; i < 8; i++) {
    brush.save();
    brush.rotate((Math.PI * i) / 4);
    brush.beginPath();
    brush.moveTo(0.6, -0.09);
    brush.lineTo(0.72, 0);
    brush.lineTo(0.6, 0.09);
    brush.stroke();
    brush.restore();
  }
}

/** A tile of stars that fits to itself on all sides; `share` of them are big. The brush counts px here. */
export function drawStars(brush: Brush, colours: Colours, size: number, count: number, biggest: number, seed: number): void {
  const roll = dice(seed);
  for (let i = 0; i < count; i++) {
    const x = size * roll();
    const y = size * roll();
    const radius = 0.4 + (biggest - 0.4) * roll() ** 4;
    brush.fillStyle = faint(colours.star, 0.25 + 0.65 * roll());
    disc(brush, x, y, radius);
  }
}

/** A soft cloud, tinted: laid large behind everything. */
export function drawHaze(brush: Brush, colours: Colours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.haze, 0.9)],
    [0.5, faint(colours.haze, 0.35)],
    [1, faint(colours.haze, 0)],
  ]);
}
