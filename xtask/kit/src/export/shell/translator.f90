! PROPS    1-9     triad of a at the start: e1a, e2a, e3a
!          10-18   triad of b at the start
!          19-21   x0, y0, z0: components of xb - xa in a's triad at the start
!          22-24   alpha0, beta0, gamma0: Cardan angles of b relative to a at the start
!          25-29   k_stick, rr, l, fc_int, mu: stiffness in stick, friction radius, overlap, internal contact force,
!                  friction coefficient; k_stick = 0: smooth
! SVARS    1-2     u1, f1: the motion along the slot since the start, and the friction force
! internal f2, f3: forces on b along e2a and e3a; the moments on b about e1a, the line of nodes and e3b
---
! TRANSLATOR with friction, as it enters a step of Newton's method: JOIN, whose first force is the friction, and ALIGN.
! Free of conditions (CC0-1.0).
module jp_connector
    use jointproof
    use jp_element
    implicit none
    private
    public :: connect
    integer, parameter, public :: multipliers = 5, states = 2, properties = 29
contains
    subroutine connect(a, b, xa, xb, lambda, props, before, after, residual, rows, force, stiffness, &
            by_multipliers, code)
        real(dp), intent(in) :: a(3, 3), b(3, 3), xa(3), xb(3), lambda(multipliers), props(:), before(states)
        real(dp), intent(out) :: after(states), residual(multipliers), rows(multipliers, 12), force(12), &
            stiffness(12, 12), by_multipliers(12, multipliers)
        integer, intent(out) :: code
        real(dp) :: x, y, z, fn, p, phi, friction, slip, normal(30), slope(10), press(5), g(9, 3), &
            r(3, 3), fa(3), ma(3), fb(3), na(3), nb(3), ua_ta(9), &
            ta_ta(9), tb_tb(9), row(12), aligning(12, 12), m(3), pressing(3), by_ta(3), by_tb(3), zero(3)
        integer :: k

        zero = 0
        after = before
        friction = 0
        slope = 0
        code = jp_translator_constraint_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), xa, xb, &
            props(2), props(3), props(4), props(5), props(6), &
            residual(1), residual(2), residual(3), residual(4), residual(5))
        if (code /= 0) return
        code = jp_slot_relative_position_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, x, y, z)
        if (code /= 0) return
        code = jp_join_rows_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, g(1:3, 1), g(4:6, 1), g(7:9, 1), &
            g(1:3, 2), g(4:6, 2), g(7:9, 2), g(1:3, 3), g(4:6, 3), g(7:9, 3))
        if (code /= 0) return
        code = jp_align_rows_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), r(:, 1), r(:, 2), r(:, 3))
        if (code /= 0) return
        code = jp_align_nodal_moments_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), &
            lambda(3), lambda(4), lambda(5), na, nb)
        if (code /= 0) return
        code = jp_align_geometric_stiffness_value(a(:, 1), a(:, 2), a(:, 3), b(:, 1), b(:, 2), b(:, 3), &
            lambda(3), lambda(4), lambda(5), tb_tb)
        if (code /= 0) return
        if (props(7) > 0) then
            ! A turn of b about e1a changes the first angle alone, by as much.
            m = [lambda(3), dot(a(:, 2), nb), dot(a(:, 3), nb)]
            after(1) = x - props(1)
            code = jp_translator_friction_jacobian(zero(1), lambda(1), lambda(2), m(1), m(2), m(3), props(8), props(9), &
                props(10), props(11), p, fn, phi, normal)
            if (code /= 0) return
            code = jp_coulomb_response_jacobian(after(1) - before(1), before(2), props(7), props(11), fn, friction, slip, slope)
            if (code /= 0) return
            after(2) = friction
            press = slope(5) * normal(12:16)
        end if
        code = jp_join_nodal_forces_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, -friction, lambda(1), lambda(2), &
            fa, ma, fb)
        if (code /= 0) return
        code = jp_join_geometric_stiffness_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, -friction, lambda(1), lambda(2), &
            ua_ta, ta_ta)
        if (code /= 0) return

        rows(1:2, :9) = transpose(g(:, 2:3))
        rows(1:2, 10:) = 0
        do k = 1, 3
            rows(2 + k, :) = spins(-r(:, k), r(:, k))
        end do
        force = nodal(fa, ma, fb, zero) + spins(na, nb)
        aligning = 0
        call put(aligning, 2, 2, transpose(block(tb_tb)))
        call put(aligning, 2, 4, -block(tb_tb))
        call put(aligning, 4, 2, -transpose(block(tb_tb)))
        call put(aligning, 4, 4, block(tb_tb))
        stiffness = along(block(ua_ta), block(ta_ta)) + aligning
        by_multipliers = transpose(rows)
        if (.not. props(7) > 0) return
        ! The moments along the other axes of a press too: they change with the moment on b, and with the axes as a turns.
        row = [g(:, 1), zero]
        pressing = a(:, 2) * press(4) + a(:, 3) * press(5)
        by_ta = cross(pressing, nb) - times(block(tb_tb), pressing)
        by_tb = times(transpose(block(tb_tb)), pressing)
        stiffness = stiffness - outer(row, row * slope(1) + spins(by_ta, by_tb))
        by_multipliers = by_multipliers - outer(row, [press(1:2), dot(pressing, r(:, 1)) + press(3), &
            (dot(pressing, r(:, k)), k = 2, 3)])
    end subroutine connect
end module jp_connector
