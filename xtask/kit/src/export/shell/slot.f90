! PROPS    1-9     triad of a at the start: e1a, e2a, e3a
!          10-18   triad of b at the start, which has no part here
!          19-21   x0, y0, z0: components of xb - xa in a's triad at the start
!          22-24   k_stick, fc_int, mu: stiffness in stick, internal contact force, friction coefficient; k_stick = 0: smooth
! SVARS    1-2     u1, f1: the motion along the slot since the start, and the friction force
! internal f2, f3: forces on b along e2a and e3a
---
! SLOT with friction, as it enters a step of Newton's method: JOIN, whose first force is the friction.
! Free of conditions (CC0-1.0).
module jp_connector
    use jointproof
    use jp_element
    implicit none
    private
    public :: connect
    integer, parameter, public :: multipliers = 2, states = 2, properties = 24
contains
    subroutine connect(a, b, xa, xb, lambda, props, before, after, residual, rows, force, stiffness, &
            by_multipliers, code)
        real(dp), intent(in) :: a(3, 3), b(3, 3), xa(3), xb(3), lambda(multipliers), props(:), before(states)
        real(dp), intent(out) :: after(states), residual(multipliers), rows(multipliers, 12), force(12), &
            stiffness(12, 12), by_multipliers(12, multipliers)
        integer, intent(out) :: code
        real(dp) :: x, y, z, fn, p, phi, friction, slip, normal(15), slope(10), pressing(2), g(9, 3), &
            fa(3), ma(3), fb(3), ua_ta(9), ta_ta(9), row(12), zero(3)

        zero = 0
        after = before
        friction = 0
        slope = 0
        code = jp_slot_constraint_value(a(:, 2), a(:, 3), xa, xb, props(2), props(3), residual(1), residual(2))
        if (code /= 0) return
        code = jp_slot_relative_position_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, x, y, z)
        if (code /= 0) return
        if (props(4) > 0) then
            after(1) = x - props(1)
            code = jp_slot_friction_jacobian(zero(1), lambda(1), lambda(2), props(5), props(6), p, fn, phi, normal)
            if (code /= 0) return
            code = jp_coulomb_response_jacobian(after(1) - before(1), before(2), props(4), props(6), fn, friction, slip, slope)
            if (code /= 0) return
            after(2) = friction
            pressing = slope(5) * normal(7:8)
        end if
        code = jp_join_rows_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, g(1:3, 1), g(4:6, 1), g(7:9, 1), &
            g(1:3, 2), g(4:6, 2), g(7:9, 2), g(1:3, 3), g(4:6, 3), g(7:9, 3))
        if (code /= 0) return
        code = jp_join_nodal_forces_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, -friction, lambda(1), lambda(2), &
            fa, ma, fb)
        if (code /= 0) return
        code = jp_join_geometric_stiffness_value(a(:, 1), a(:, 2), a(:, 3), xa, xb, -friction, lambda(1), lambda(2), &
            ua_ta, ta_ta)
        if (code /= 0) return

        rows(:, :9) = transpose(g(:, 2:3))
        rows(:, 10:) = 0
        force = nodal(fa, ma, fb, zero)
        stiffness = along(block(ua_ta), block(ta_ta))
        by_multipliers = transpose(rows)
        if (.not. props(4) > 0) return
        ! Friction follows the motion in stick, and the multipliers in slip.
        row = [g(:, 1), zero]
        stiffness = stiffness - outer(row, row * slope(1))
        by_multipliers = by_multipliers - outer(row, pressing)
    end subroutine connect
end module jp_connector
